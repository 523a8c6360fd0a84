/* CasADi's own C for rover: prototypes. */
int rover_casadi_gps(const double **arg, double **res, long long int *iw, double *w, int mem);
int rover_casadi_gps_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int rover_casadi_range(const double **arg, double **res, long long int *iw, double *w, int mem);
int rover_casadi_range_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int rover_casadi_imu(const double **arg, double **res, long long int *iw, double *w, int mem);
int rover_casadi_imu_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
