/* CasADi's own C for ekf_cal_online: prototypes. */
int ekf_cal_online_casadi_gps_1(const double **arg, double **res, long long int *iw, double *w, int mem);
int ekf_cal_online_casadi_gps_1_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int ekf_cal_online_casadi_gps_2(const double **arg, double **res, long long int *iw, double *w, int mem);
int ekf_cal_online_casadi_gps_2_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
