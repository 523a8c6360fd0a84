/* CasADi's own C for warpos_gps: prototypes. */
int warpos_gps_casadi_measurement(const double **arg, double **res, long long int *iw, double *w, int mem);
int warpos_gps_casadi_measurement_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int warpos_gps_casadi_measurement_by_column(const double **arg, double **res, long long int *iw, double *w, int mem);
int warpos_gps_casadi_measurement_by_column_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int warpos_gps_casadi_observed(const double **arg, double **res, long long int *iw, double *w, int mem);
int warpos_gps_casadi_observed_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int warpos_gps_casadi_observed_by_column(const double **arg, double **res, long long int *iw, double *w, int mem);
int warpos_gps_casadi_observed_by_column_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int warpos_gps_casadi_to_state_frame(const double **arg, double **res, long long int *iw, double *w, int mem);
int warpos_gps_casadi_to_state_frame_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
