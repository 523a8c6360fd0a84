/* CasADi's own C for farrell_tightly_coupled: prototypes. */
int farrell_tightly_coupled_casadi_pseudorange(const double **arg, double **res, long long int *iw, double *w, int mem);
int farrell_tightly_coupled_casadi_pseudorange_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
int farrell_tightly_coupled_casadi_pseudorange_lever_arm(const double **arg, double **res, long long int *iw, double *w, int mem);
int farrell_tightly_coupled_casadi_pseudorange_lever_arm_work(long long int *sz_arg, long long int *sz_res, long long int *sz_iw, long long int *sz_w);
