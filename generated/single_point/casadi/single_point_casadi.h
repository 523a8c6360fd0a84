/* CasADi's own C for single_point: prototypes. */
int single_point_casadi_pseudorange(const double **arg, double **res, long long int *iw, double *w, int mem);
int single_point_casadi_pseudorange_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int single_point_casadi_pseudorange_without_sagnac(const double **arg, double **res, long long int *iw, double *w, int mem);
int single_point_casadi_pseudorange_without_sagnac_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int single_point_casadi_broadcast_orbit(const double **arg, double **res, long long int *iw, double *w, int mem);
int single_point_casadi_broadcast_orbit_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
