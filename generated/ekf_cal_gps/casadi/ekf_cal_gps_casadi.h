/* CasADi's own C for ekf_cal_gps: prototypes. */
int ekf_cal_gps_casadi_gps(const double **arg, double **res, long long int *iw, double *w, int mem);
int ekf_cal_gps_casadi_gps_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int ekf_cal_gps_casadi_gps_known_antenna(const double **arg, double **res, long long int *iw, double *w, int mem);
int ekf_cal_gps_casadi_gps_known_antenna_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int ekf_cal_gps_casadi_local_fix(const double **arg, double **res, long long int *iw, double *w, int mem);
int ekf_cal_gps_casadi_local_fix_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
