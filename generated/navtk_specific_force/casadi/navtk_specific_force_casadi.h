/* CasADi's own C for navtk_specific_force: prototypes. */
int navtk_specific_force_casadi_calc_force(const double **arg, double **res, long long int *iw, double *w, int mem);
int navtk_specific_force_casadi_calc_force_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int navtk_specific_force_casadi_force(const double **arg, double **res, long long int *iw, double *w, int mem);
int navtk_specific_force_casadi_force_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
