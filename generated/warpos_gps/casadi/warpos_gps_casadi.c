/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) warpos_gps_casadi_ ## ID
#endif

#include <math.h>

#ifndef casadi_real
#define casadi_real double
#endif

#ifndef casadi_int
#define casadi_int long long int
#endif

/* Add prefix to internal symbols */
#define casadi_f0 CASADI_PREFIX(f0)
#define casadi_f1 CASADI_PREFIX(f1)
#define casadi_f2 CASADI_PREFIX(f2)
#define casadi_f3 CASADI_PREFIX(f3)
#define casadi_f4 CASADI_PREFIX(f4)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)
#define casadi_s4 CASADI_PREFIX(s4)

/* Symbol visibility in DLLs */
#ifndef CASADI_SYMBOL_EXPORT
  #if defined(_WIN32) || defined(__WIN32__) || defined(__CYGWIN__)
    #if defined(STATIC_LINKED)
      #define CASADI_SYMBOL_EXPORT
    #else
      #define CASADI_SYMBOL_EXPORT __declspec(dllexport)
    #endif
  #elif defined(__GNUC__) && defined(GCC_HASCLASSVISIBILITY)
    #define CASADI_SYMBOL_EXPORT __attribute__ ((visibility ("default")))
  #else
    #define CASADI_SYMBOL_EXPORT
  #endif
#endif

/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void warpos_gps_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int warpos_gps_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int warpos_gps_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {15, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {3, 15, 1};
static const casadi_int casadi_s3[3] = {4, 1, 1};
static const casadi_int casadi_s4[3] = {9, 1, 1};

/* warpos_gps_casadi_measurement:(i0[15])->(o0[3],o1[3x15]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[0]? arg[0][4] : 0;
  if (res[0]!=0) res[0][0]=a0;
  a0=arg[0]? arg[0][5] : 0;
  if (res[0]!=0) res[0][1]=a0;
  a0=arg[0]? arg[0][6] : 0;
  if (res[0]!=0) res[0][2]=a0;
  a0=0.;
  if (res[1]!=0) res[1][0]=a0;
  if (res[1]!=0) res[1][1]=a0;
  if (res[1]!=0) res[1][2]=a0;
  if (res[1]!=0) res[1][3]=a0;
  if (res[1]!=0) res[1][4]=a0;
  if (res[1]!=0) res[1][5]=a0;
  if (res[1]!=0) res[1][6]=a0;
  if (res[1]!=0) res[1][7]=a0;
  if (res[1]!=0) res[1][8]=a0;
  if (res[1]!=0) res[1][9]=a0;
  if (res[1]!=0) res[1][10]=a0;
  if (res[1]!=0) res[1][11]=a0;
  a1=1.;
  if (res[1]!=0) res[1][12]=a1;
  if (res[1]!=0) res[1][13]=a0;
  if (res[1]!=0) res[1][14]=a0;
  if (res[1]!=0) res[1][15]=a0;
  if (res[1]!=0) res[1][16]=a1;
  if (res[1]!=0) res[1][17]=a0;
  if (res[1]!=0) res[1][18]=a0;
  if (res[1]!=0) res[1][19]=a0;
  if (res[1]!=0) res[1][20]=a1;
  if (res[1]!=0) res[1][21]=a0;
  if (res[1]!=0) res[1][22]=a0;
  if (res[1]!=0) res[1][23]=a0;
  if (res[1]!=0) res[1][24]=a0;
  if (res[1]!=0) res[1][25]=a0;
  if (res[1]!=0) res[1][26]=a0;
  if (res[1]!=0) res[1][27]=a0;
  if (res[1]!=0) res[1][28]=a0;
  if (res[1]!=0) res[1][29]=a0;
  if (res[1]!=0) res[1][30]=a0;
  if (res[1]!=0) res[1][31]=a0;
  if (res[1]!=0) res[1][32]=a0;
  if (res[1]!=0) res[1][33]=a0;
  if (res[1]!=0) res[1][34]=a0;
  if (res[1]!=0) res[1][35]=a0;
  if (res[1]!=0) res[1][36]=a0;
  if (res[1]!=0) res[1][37]=a0;
  if (res[1]!=0) res[1][38]=a0;
  if (res[1]!=0) res[1][39]=a0;
  if (res[1]!=0) res[1][40]=a0;
  if (res[1]!=0) res[1][41]=a0;
  if (res[1]!=0) res[1][42]=a0;
  if (res[1]!=0) res[1][43]=a0;
  if (res[1]!=0) res[1][44]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_measurement(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_measurement_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_measurement_release(int mem) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_measurement_incref(void) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_measurement_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_measurement_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_measurement_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real warpos_gps_casadi_measurement_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_measurement_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_measurement_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_measurement_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_measurement_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_measurement_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_measurement_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* warpos_gps_casadi_measurement_by_column:(i0[15])->(o0[3],o1[3x15]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1;
  a0=arg[0]? arg[0][4] : 0;
  if (res[0]!=0) res[0][0]=a0;
  a0=arg[0]? arg[0][5] : 0;
  if (res[0]!=0) res[0][1]=a0;
  a0=arg[0]? arg[0][6] : 0;
  if (res[0]!=0) res[0][2]=a0;
  a0=0.;
  if (res[1]!=0) res[1][0]=a0;
  if (res[1]!=0) res[1][1]=a0;
  if (res[1]!=0) res[1][2]=a0;
  if (res[1]!=0) res[1][3]=a0;
  if (res[1]!=0) res[1][4]=a0;
  if (res[1]!=0) res[1][5]=a0;
  if (res[1]!=0) res[1][6]=a0;
  if (res[1]!=0) res[1][7]=a0;
  if (res[1]!=0) res[1][8]=a0;
  if (res[1]!=0) res[1][9]=a0;
  if (res[1]!=0) res[1][10]=a0;
  if (res[1]!=0) res[1][11]=a0;
  a1=1.;
  if (res[1]!=0) res[1][12]=a1;
  if (res[1]!=0) res[1][13]=a0;
  if (res[1]!=0) res[1][14]=a0;
  if (res[1]!=0) res[1][15]=a0;
  if (res[1]!=0) res[1][16]=a1;
  if (res[1]!=0) res[1][17]=a0;
  if (res[1]!=0) res[1][18]=a0;
  if (res[1]!=0) res[1][19]=a0;
  if (res[1]!=0) res[1][20]=a1;
  if (res[1]!=0) res[1][21]=a0;
  if (res[1]!=0) res[1][22]=a0;
  if (res[1]!=0) res[1][23]=a0;
  if (res[1]!=0) res[1][24]=a0;
  if (res[1]!=0) res[1][25]=a0;
  if (res[1]!=0) res[1][26]=a0;
  if (res[1]!=0) res[1][27]=a0;
  if (res[1]!=0) res[1][28]=a0;
  if (res[1]!=0) res[1][29]=a0;
  if (res[1]!=0) res[1][30]=a0;
  if (res[1]!=0) res[1][31]=a0;
  if (res[1]!=0) res[1][32]=a0;
  if (res[1]!=0) res[1][33]=a0;
  if (res[1]!=0) res[1][34]=a0;
  if (res[1]!=0) res[1][35]=a0;
  if (res[1]!=0) res[1][36]=a0;
  if (res[1]!=0) res[1][37]=a0;
  if (res[1]!=0) res[1][38]=a0;
  if (res[1]!=0) res[1][39]=a0;
  if (res[1]!=0) res[1][40]=a0;
  if (res[1]!=0) res[1][41]=a0;
  if (res[1]!=0) res[1][42]=a0;
  if (res[1]!=0) res[1][43]=a0;
  if (res[1]!=0) res[1][44]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_measurement_by_column(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_measurement_by_column_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_measurement_by_column_release(int mem) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_measurement_by_column_incref(void) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_measurement_by_column_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_measurement_by_column_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_measurement_by_column_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real warpos_gps_casadi_measurement_by_column_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_measurement_by_column_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_measurement_by_column_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_measurement_by_column_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_measurement_by_column_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_measurement_by_column_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_measurement_by_column_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* warpos_gps_casadi_observed:(i0[15],i1[4])->(o0[3],o1[3x15]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16;
  a00=arg[0]? arg[0][4] : 0;
  a01=1.;
  a02=arg[1]? arg[1][2] : 0;
  a03=(2.*a02);
  a04=(a03*a02);
  a05=(a01-a04);
  a06=arg[1]? arg[1][3] : 0;
  a07=(2.*a06);
  a08=(a07*a06);
  a05=(a05-a08);
  a05=(a00*a05);
  a09=arg[0]? arg[0][5] : 0;
  a10=arg[1]? arg[1][0] : 0;
  a11=(a07*a10);
  a12=arg[1]? arg[1][1] : 0;
  a13=(a03*a12);
  a14=(a11+a13);
  a14=(a09*a14);
  a05=(a05+a14);
  a14=arg[0]? arg[0][6] : 0;
  a15=(a07*a12);
  a03=(a03*a10);
  a16=(a15-a03);
  a16=(a14*a16);
  a05=(a05+a16);
  if (res[0]!=0) res[0][0]=a05;
  a13=(a13-a11);
  a13=(a00*a13);
  a11=(2.*a12);
  a05=(a11*a12);
  a16=(a01-a05);
  a16=(a16-a08);
  a16=(a09*a16);
  a13=(a13+a16);
  a11=(a11*a10);
  a07=(a07*a02);
  a16=(a11+a07);
  a16=(a14*a16);
  a13=(a13+a16);
  if (res[0]!=0) res[0][1]=a13;
  a03=(a03+a15);
  a00=(a00*a03);
  a07=(a07-a11);
  a09=(a09*a07);
  a00=(a00+a09);
  a05=(a01-a05);
  a05=(a05-a04);
  a14=(a14*a05);
  a00=(a00+a14);
  if (res[0]!=0) res[0][2]=a00;
  a00=0.;
  if (res[1]!=0) res[1][0]=a00;
  if (res[1]!=0) res[1][1]=a00;
  if (res[1]!=0) res[1][2]=a00;
  if (res[1]!=0) res[1][3]=a00;
  if (res[1]!=0) res[1][4]=a00;
  if (res[1]!=0) res[1][5]=a00;
  if (res[1]!=0) res[1][6]=a00;
  if (res[1]!=0) res[1][7]=a00;
  if (res[1]!=0) res[1][8]=a00;
  if (res[1]!=0) res[1][9]=a00;
  if (res[1]!=0) res[1][10]=a00;
  if (res[1]!=0) res[1][11]=a00;
  a14=(2.*a02);
  a05=(a14*a02);
  a04=(a01-a05);
  a09=(2.*a06);
  a06=(a09*a06);
  a04=(a04-a06);
  if (res[1]!=0) res[1][12]=a04;
  a04=(a14*a12);
  a07=(a09*a10);
  a11=(a04-a07);
  if (res[1]!=0) res[1][13]=a11;
  a14=(a14*a10);
  a11=(a09*a12);
  a03=(a14+a11);
  if (res[1]!=0) res[1][14]=a03;
  a07=(a07+a04);
  if (res[1]!=0) res[1][15]=a07;
  a07=(2.*a12);
  a12=(a07*a12);
  a04=(a01-a12);
  a04=(a04-a06);
  if (res[1]!=0) res[1][16]=a04;
  a09=(a09*a02);
  a07=(a07*a10);
  a10=(a09-a07);
  if (res[1]!=0) res[1][17]=a10;
  a11=(a11-a14);
  if (res[1]!=0) res[1][18]=a11;
  a07=(a07+a09);
  if (res[1]!=0) res[1][19]=a07;
  a01=(a01-a12);
  a01=(a01-a05);
  if (res[1]!=0) res[1][20]=a01;
  if (res[1]!=0) res[1][21]=a00;
  if (res[1]!=0) res[1][22]=a00;
  if (res[1]!=0) res[1][23]=a00;
  if (res[1]!=0) res[1][24]=a00;
  if (res[1]!=0) res[1][25]=a00;
  if (res[1]!=0) res[1][26]=a00;
  if (res[1]!=0) res[1][27]=a00;
  if (res[1]!=0) res[1][28]=a00;
  if (res[1]!=0) res[1][29]=a00;
  if (res[1]!=0) res[1][30]=a00;
  if (res[1]!=0) res[1][31]=a00;
  if (res[1]!=0) res[1][32]=a00;
  if (res[1]!=0) res[1][33]=a00;
  if (res[1]!=0) res[1][34]=a00;
  if (res[1]!=0) res[1][35]=a00;
  if (res[1]!=0) res[1][36]=a00;
  if (res[1]!=0) res[1][37]=a00;
  if (res[1]!=0) res[1][38]=a00;
  if (res[1]!=0) res[1][39]=a00;
  if (res[1]!=0) res[1][40]=a00;
  if (res[1]!=0) res[1][41]=a00;
  if (res[1]!=0) res[1][42]=a00;
  if (res[1]!=0) res[1][43]=a00;
  if (res[1]!=0) res[1][44]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_observed(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f2(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_observed_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_observed_release(int mem) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_observed_incref(void) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_observed_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_observed_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_observed_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real warpos_gps_casadi_observed_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_observed_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_observed_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_observed_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_observed_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_observed_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_observed_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* warpos_gps_casadi_observed_by_column:(i0[15],i1[4])->(o0[3],o1[3x15]) */
static int casadi_f3(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16;
  a00=arg[0]? arg[0][4] : 0;
  a01=1.;
  a02=arg[1]? arg[1][2] : 0;
  a03=(2.*a02);
  a04=(a03*a02);
  a05=(a01-a04);
  a06=arg[1]? arg[1][3] : 0;
  a07=(2.*a06);
  a08=(a07*a06);
  a05=(a05-a08);
  a05=(a00*a05);
  a09=arg[0]? arg[0][5] : 0;
  a10=arg[1]? arg[1][0] : 0;
  a11=(a07*a10);
  a12=arg[1]? arg[1][1] : 0;
  a13=(a03*a12);
  a14=(a11+a13);
  a14=(a09*a14);
  a05=(a05+a14);
  a14=arg[0]? arg[0][6] : 0;
  a15=(a07*a12);
  a03=(a03*a10);
  a16=(a15-a03);
  a16=(a14*a16);
  a05=(a05+a16);
  if (res[0]!=0) res[0][0]=a05;
  a13=(a13-a11);
  a13=(a00*a13);
  a11=(2.*a12);
  a05=(a11*a12);
  a16=(a01-a05);
  a16=(a16-a08);
  a16=(a09*a16);
  a13=(a13+a16);
  a11=(a11*a10);
  a07=(a07*a02);
  a16=(a11+a07);
  a16=(a14*a16);
  a13=(a13+a16);
  if (res[0]!=0) res[0][1]=a13;
  a03=(a03+a15);
  a00=(a00*a03);
  a07=(a07-a11);
  a09=(a09*a07);
  a00=(a00+a09);
  a05=(a01-a05);
  a05=(a05-a04);
  a14=(a14*a05);
  a00=(a00+a14);
  if (res[0]!=0) res[0][2]=a00;
  a00=0.;
  if (res[1]!=0) res[1][0]=a00;
  if (res[1]!=0) res[1][1]=a00;
  if (res[1]!=0) res[1][2]=a00;
  if (res[1]!=0) res[1][3]=a00;
  if (res[1]!=0) res[1][4]=a00;
  if (res[1]!=0) res[1][5]=a00;
  if (res[1]!=0) res[1][6]=a00;
  if (res[1]!=0) res[1][7]=a00;
  if (res[1]!=0) res[1][8]=a00;
  if (res[1]!=0) res[1][9]=a00;
  if (res[1]!=0) res[1][10]=a00;
  if (res[1]!=0) res[1][11]=a00;
  a14=(2.*a02);
  a05=(a14*a02);
  a04=(a01-a05);
  a09=(2.*a06);
  a06=(a09*a06);
  a04=(a04-a06);
  if (res[1]!=0) res[1][12]=a04;
  a04=(a14*a12);
  a07=(a09*a10);
  a11=(a04-a07);
  if (res[1]!=0) res[1][13]=a11;
  a14=(a14*a10);
  a11=(a09*a12);
  a03=(a14+a11);
  if (res[1]!=0) res[1][14]=a03;
  a07=(a07+a04);
  if (res[1]!=0) res[1][15]=a07;
  a07=(2.*a12);
  a12=(a07*a12);
  a04=(a01-a12);
  a04=(a04-a06);
  if (res[1]!=0) res[1][16]=a04;
  a09=(a09*a02);
  a07=(a07*a10);
  a10=(a09-a07);
  if (res[1]!=0) res[1][17]=a10;
  a11=(a11-a14);
  if (res[1]!=0) res[1][18]=a11;
  a07=(a07+a09);
  if (res[1]!=0) res[1][19]=a07;
  a01=(a01-a12);
  a01=(a01-a05);
  if (res[1]!=0) res[1][20]=a01;
  if (res[1]!=0) res[1][21]=a00;
  if (res[1]!=0) res[1][22]=a00;
  if (res[1]!=0) res[1][23]=a00;
  if (res[1]!=0) res[1][24]=a00;
  if (res[1]!=0) res[1][25]=a00;
  if (res[1]!=0) res[1][26]=a00;
  if (res[1]!=0) res[1][27]=a00;
  if (res[1]!=0) res[1][28]=a00;
  if (res[1]!=0) res[1][29]=a00;
  if (res[1]!=0) res[1][30]=a00;
  if (res[1]!=0) res[1][31]=a00;
  if (res[1]!=0) res[1][32]=a00;
  if (res[1]!=0) res[1][33]=a00;
  if (res[1]!=0) res[1][34]=a00;
  if (res[1]!=0) res[1][35]=a00;
  if (res[1]!=0) res[1][36]=a00;
  if (res[1]!=0) res[1][37]=a00;
  if (res[1]!=0) res[1][38]=a00;
  if (res[1]!=0) res[1][39]=a00;
  if (res[1]!=0) res[1][40]=a00;
  if (res[1]!=0) res[1][41]=a00;
  if (res[1]!=0) res[1][42]=a00;
  if (res[1]!=0) res[1][43]=a00;
  if (res[1]!=0) res[1][44]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_observed_by_column(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f3(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_observed_by_column_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_observed_by_column_release(int mem) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_observed_by_column_incref(void) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_observed_by_column_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_observed_by_column_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_observed_by_column_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real warpos_gps_casadi_observed_by_column_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_observed_by_column_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_observed_by_column_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_observed_by_column_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_observed_by_column_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_observed_by_column_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_observed_by_column_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* warpos_gps_casadi_to_state_frame:(i0[4],i1[3],i2[3],i3[4],i4[3],i5[9])->(o0[3],o1[9]) */
static int casadi_f4(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30;
  a00=1.;
  a01=arg[0]? arg[0][2] : 0;
  a02=(2.*a01);
  a03=(a02*a01);
  a04=(a00-a03);
  a05=arg[0]? arg[0][3] : 0;
  a06=(2.*a05);
  a07=(a06*a05);
  a04=(a04-a07);
  a08=arg[1]? arg[1][0] : 0;
  a04=(a04*a08);
  a09=arg[0]? arg[0][1] : 0;
  a10=(a02*a09);
  a11=arg[0]? arg[0][0] : 0;
  a12=(a06*a11);
  a13=(a10-a12);
  a14=arg[1]? arg[1][1] : 0;
  a13=(a13*a14);
  a04=(a04+a13);
  a02=(a02*a11);
  a13=(a06*a09);
  a15=(a02+a13);
  a16=arg[1]? arg[1][2] : 0;
  a15=(a15*a16);
  a04=(a04+a15);
  a15=arg[3]? arg[3][2] : 0;
  a17=(2.*a15);
  a18=(a17*a15);
  a19=(a00-a18);
  a20=arg[3]? arg[3][3] : 0;
  a21=(2.*a20);
  a20=(a21*a20);
  a19=(a19-a20);
  a22=arg[4]? arg[4][0] : 0;
  a19=(a19*a22);
  a23=arg[3]? arg[3][1] : 0;
  a24=(a17*a23);
  a25=arg[3]? arg[3][0] : 0;
  a26=(a21*a25);
  a27=(a24-a26);
  a28=arg[4]? arg[4][1] : 0;
  a27=(a27*a28);
  a19=(a19+a27);
  a17=(a17*a25);
  a27=(a21*a23);
  a29=(a17+a27);
  a30=arg[4]? arg[4][2] : 0;
  a29=(a29*a30);
  a19=(a19+a29);
  a04=(a04-a19);
  a19=arg[2]? arg[2][0] : 0;
  a04=(a04-a19);
  if (res[0]!=0) res[0][0]=a04;
  a12=(a12+a10);
  a12=(a12*a08);
  a10=(2.*a09);
  a04=(a10*a09);
  a19=(a00-a04);
  a19=(a19-a07);
  a19=(a19*a14);
  a12=(a12+a19);
  a06=(a06*a01);
  a10=(a10*a11);
  a19=(a06-a10);
  a19=(a19*a16);
  a12=(a12+a19);
  a26=(a26+a24);
  a26=(a26*a22);
  a24=(2.*a23);
  a23=(a24*a23);
  a19=(a00-a23);
  a19=(a19-a20);
  a19=(a19*a28);
  a26=(a26+a19);
  a21=(a21*a15);
  a24=(a24*a25);
  a25=(a21-a24);
  a25=(a25*a30);
  a26=(a26+a25);
  a12=(a12-a26);
  a26=arg[2]? arg[2][1] : 0;
  a12=(a12-a26);
  if (res[0]!=0) res[0][1]=a12;
  a13=(a13-a02);
  a13=(a13*a08);
  a10=(a10+a06);
  a10=(a10*a14);
  a13=(a13+a10);
  a04=(a00-a04);
  a04=(a04-a03);
  a04=(a04*a16);
  a13=(a13+a04);
  a27=(a27-a17);
  a27=(a27*a22);
  a24=(a24+a21);
  a24=(a24*a28);
  a27=(a27+a24);
  a23=(a00-a23);
  a23=(a23-a18);
  a23=(a23*a30);
  a27=(a27+a23);
  a13=(a13-a27);
  a27=arg[2]? arg[2][2] : 0;
  a13=(a13-a27);
  if (res[0]!=0) res[0][2]=a13;
  a13=(2.*a01);
  a27=(a13*a01);
  a23=(a00-a27);
  a30=(2.*a05);
  a05=(a30*a05);
  a23=(a23-a05);
  a18=arg[5]? arg[5][0] : 0;
  a24=(a23*a18);
  a28=(a13*a09);
  a21=(a30*a11);
  a22=(a28-a21);
  a17=arg[5]? arg[5][3] : 0;
  a04=(a22*a17);
  a24=(a24+a04);
  a13=(a13*a11);
  a04=(a30*a09);
  a16=(a13+a04);
  a03=arg[5]? arg[5][6] : 0;
  a10=(a16*a03);
  a24=(a24+a10);
  a10=(a24*a23);
  a14=arg[5]? arg[5][1] : 0;
  a06=(a23*a14);
  a08=arg[5]? arg[5][4] : 0;
  a02=(a22*a08);
  a06=(a06+a02);
  a02=arg[5]? arg[5][7] : 0;
  a12=(a16*a02);
  a06=(a06+a12);
  a12=(a06*a22);
  a10=(a10+a12);
  a12=arg[5]? arg[5][2] : 0;
  a26=(a23*a12);
  a25=arg[5]? arg[5][5] : 0;
  a15=(a22*a25);
  a26=(a26+a15);
  a15=arg[5]? arg[5][8] : 0;
  a19=(a16*a15);
  a26=(a26+a19);
  a19=(a26*a16);
  a10=(a10+a19);
  if (res[1]!=0) res[1][0]=a10;
  a21=(a21+a28);
  a28=(a24*a21);
  a10=(2.*a09);
  a09=(a10*a09);
  a19=(a00-a09);
  a19=(a19-a05);
  a05=(a06*a19);
  a28=(a28+a05);
  a30=(a30*a01);
  a10=(a10*a11);
  a11=(a30-a10);
  a01=(a26*a11);
  a28=(a28+a01);
  if (res[1]!=0) res[1][1]=a28;
  a04=(a04-a13);
  a24=(a24*a04);
  a10=(a10+a30);
  a06=(a06*a10);
  a24=(a24+a06);
  a00=(a00-a09);
  a00=(a00-a27);
  a26=(a26*a00);
  a24=(a24+a26);
  if (res[1]!=0) res[1][2]=a24;
  a24=(a21*a18);
  a26=(a19*a17);
  a24=(a24+a26);
  a26=(a11*a03);
  a24=(a24+a26);
  a26=(a24*a23);
  a27=(a21*a14);
  a09=(a19*a08);
  a27=(a27+a09);
  a09=(a11*a02);
  a27=(a27+a09);
  a09=(a27*a22);
  a26=(a26+a09);
  a09=(a21*a12);
  a06=(a19*a25);
  a09=(a09+a06);
  a06=(a11*a15);
  a09=(a09+a06);
  a06=(a09*a16);
  a26=(a26+a06);
  if (res[1]!=0) res[1][3]=a26;
  a26=(a24*a21);
  a06=(a27*a19);
  a26=(a26+a06);
  a06=(a09*a11);
  a26=(a26+a06);
  if (res[1]!=0) res[1][4]=a26;
  a24=(a24*a04);
  a27=(a27*a10);
  a24=(a24+a27);
  a09=(a09*a00);
  a24=(a24+a09);
  if (res[1]!=0) res[1][5]=a24;
  a18=(a04*a18);
  a17=(a10*a17);
  a18=(a18+a17);
  a03=(a00*a03);
  a18=(a18+a03);
  a23=(a18*a23);
  a14=(a04*a14);
  a08=(a10*a08);
  a14=(a14+a08);
  a02=(a00*a02);
  a14=(a14+a02);
  a22=(a14*a22);
  a23=(a23+a22);
  a12=(a04*a12);
  a25=(a10*a25);
  a12=(a12+a25);
  a15=(a00*a15);
  a12=(a12+a15);
  a16=(a12*a16);
  a23=(a23+a16);
  if (res[1]!=0) res[1][6]=a23;
  a21=(a18*a21);
  a19=(a14*a19);
  a21=(a21+a19);
  a11=(a12*a11);
  a21=(a21+a11);
  if (res[1]!=0) res[1][7]=a21;
  a18=(a18*a04);
  a14=(a14*a10);
  a18=(a18+a14);
  a12=(a12*a00);
  a18=(a18+a12);
  if (res[1]!=0) res[1][8]=a18;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_to_state_frame(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f4(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_to_state_frame_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_to_state_frame_release(int mem) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_to_state_frame_incref(void) {
}

CASADI_SYMBOL_EXPORT void warpos_gps_casadi_to_state_frame_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_to_state_frame_n_in(void) { return 6;}

CASADI_SYMBOL_EXPORT casadi_int warpos_gps_casadi_to_state_frame_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real warpos_gps_casadi_to_state_frame_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_to_state_frame_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    case 4: return "i4";
    case 5: return "i5";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* warpos_gps_casadi_to_state_frame_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_to_state_frame_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s3;
    case 4: return casadi_s1;
    case 5: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* warpos_gps_casadi_to_state_frame_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_to_state_frame_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 6;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int warpos_gps_casadi_to_state_frame_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


