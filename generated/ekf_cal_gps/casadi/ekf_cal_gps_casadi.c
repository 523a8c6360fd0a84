/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ekf_cal_gps_casadi_ ## ID
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
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)
#define casadi_s4 CASADI_PREFIX(s4)
#define casadi_s5 CASADI_PREFIX(s5)
#define casadi_sq CASADI_PREFIX(sq)

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

casadi_real casadi_sq(casadi_real x) { return x*x;}

/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {22, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {3, 21, 1};
static const casadi_int casadi_s3[3] = {1, 1, 1};
static const casadi_int casadi_s4[3] = {9, 1, 1};
static const casadi_int casadi_s5[3] = {3, 3, 1};

/* ekf_cal_gps_casadi_gps:(i0[22],i1[3])->(o0[3],o1[3],o2[3x21]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25;
  a00=arg[0]? arg[0][19] : 0;
  a01=1.;
  a02=arg[0]? arg[0][11] : 0;
  a03=(2.*a02);
  a04=(a03*a02);
  a05=(a01-a04);
  a06=arg[0]? arg[0][12] : 0;
  a07=(2.*a06);
  a08=(a07*a06);
  a05=(a05-a08);
  a05=(a00*a05);
  a09=arg[0]? arg[0][20] : 0;
  a10=arg[0]? arg[0][10] : 0;
  a11=(a03*a10);
  a12=arg[0]? arg[0][9] : 0;
  a13=(a07*a12);
  a14=(a11-a13);
  a14=(a09*a14);
  a05=(a05+a14);
  a14=arg[0]? arg[0][21] : 0;
  a03=(a03*a12);
  a15=(a07*a10);
  a16=(a03+a15);
  a16=(a14*a16);
  a05=(a05+a16);
  a16=arg[0]? arg[0][0] : 0;
  a05=(a05+a16);
  if (res[0]!=0) res[0][0]=a05;
  a13=(a13+a11);
  a13=(a00*a13);
  a11=(2.*a10);
  a16=(a11*a10);
  a17=(a01-a16);
  a17=(a17-a08);
  a17=(a09*a17);
  a13=(a13+a17);
  a07=(a07*a02);
  a11=(a11*a12);
  a17=(a07-a11);
  a17=(a14*a17);
  a13=(a13+a17);
  a17=arg[0]? arg[0][1] : 0;
  a13=(a13+a17);
  if (res[0]!=0) res[0][1]=a13;
  a15=(a15-a03);
  a15=(a00*a15);
  a11=(a11+a07);
  a11=(a09*a11);
  a15=(a15+a11);
  a16=(a01-a16);
  a16=(a16-a04);
  a16=(a14*a16);
  a15=(a15+a16);
  a16=arg[0]? arg[0][2] : 0;
  a15=(a15+a16);
  if (res[0]!=0) res[0][2]=a15;
  a16=arg[1]? arg[1][0] : 0;
  a16=(a16-a05);
  if (res[1]!=0) res[1][0]=a16;
  a16=arg[1]? arg[1][1] : 0;
  a16=(a16-a13);
  if (res[1]!=0) res[1][1]=a16;
  a16=arg[1]? arg[1][2] : 0;
  a16=(a16-a15);
  if (res[1]!=0) res[1][2]=a16;
  if (res[2]!=0) res[2][0]=a01;
  a16=0.;
  if (res[2]!=0) res[2][1]=a16;
  if (res[2]!=0) res[2][2]=a16;
  if (res[2]!=0) res[2][3]=a16;
  if (res[2]!=0) res[2][4]=a01;
  if (res[2]!=0) res[2][5]=a16;
  if (res[2]!=0) res[2][6]=a16;
  if (res[2]!=0) res[2][7]=a16;
  if (res[2]!=0) res[2][8]=a01;
  if (res[2]!=0) res[2][9]=a16;
  if (res[2]!=0) res[2][10]=a16;
  if (res[2]!=0) res[2][11]=a16;
  if (res[2]!=0) res[2][12]=a16;
  if (res[2]!=0) res[2][13]=a16;
  if (res[2]!=0) res[2][14]=a16;
  if (res[2]!=0) res[2][15]=a16;
  if (res[2]!=0) res[2][16]=a16;
  if (res[2]!=0) res[2][17]=a16;
  if (res[2]!=0) res[2][18]=a16;
  if (res[2]!=0) res[2][19]=a16;
  if (res[2]!=0) res[2][20]=a16;
  if (res[2]!=0) res[2][21]=a16;
  if (res[2]!=0) res[2][22]=a16;
  if (res[2]!=0) res[2][23]=a16;
  if (res[2]!=0) res[2][24]=a16;
  if (res[2]!=0) res[2][25]=a16;
  if (res[2]!=0) res[2][26]=a16;
  a15=5.0000000000000000e-01;
  a13=(2.*a06);
  a05=(a13*a14);
  a04=(2.*a02);
  a11=(a04*a09);
  a05=(a05+a11);
  a11=(a12*a05);
  a07=(a04*a14);
  a03=(a13*a09);
  a07=(a07-a03);
  a03=(a10*a07);
  a11=(a11-a03);
  a03=(a10*a14);
  a17=(a12*a09);
  a03=(a03-a17);
  a17=(a06*a00);
  a03=(a03-a17);
  a03=(2.*a03);
  a17=(a13*a00);
  a03=(a03-a17);
  a17=(a02*a03);
  a11=(a11-a17);
  a17=(a12*a14);
  a08=(a10*a09);
  a17=(a17+a08);
  a08=(a02*a00);
  a17=(a17-a08);
  a17=(2.*a17);
  a08=(a04*a00);
  a17=(a17-a08);
  a08=(a06*a17);
  a11=(a11+a08);
  a11=(a15*a11);
  if (res[2]!=0) res[2][27]=a11;
  a11=(a12*a14);
  a08=(a10*a09);
  a11=(a11+a08);
  a11=(-a11);
  a11=(2.*a11);
  a08=(2.*a10);
  a18=(a08*a09);
  a11=(a11-a18);
  a18=(a04*a00);
  a11=(a11+a18);
  a18=(a12*a11);
  a19=(a13*a00);
  a20=(a08*a14);
  a19=(a19-a20);
  a20=(a10*a19);
  a18=(a18-a20);
  a20=(a02*a14);
  a21=(a12*a00);
  a20=(a20+a21);
  a21=(a06*a09);
  a20=(a20-a21);
  a20=(2.*a20);
  a21=(a13*a09);
  a20=(a20-a21);
  a21=(a02*a20);
  a18=(a18-a21);
  a21=(a13*a14);
  a22=(a10*a00);
  a22=(2.*a22);
  a21=(a21+a22);
  a22=(a06*a21);
  a18=(a18+a22);
  a18=(a15*a18);
  if (res[2]!=0) res[2][28]=a18;
  a18=(a12*a09);
  a22=(a10*a14);
  a18=(a18-a22);
  a18=(2.*a18);
  a22=(a08*a14);
  a18=(a18-a22);
  a22=(a13*a00);
  a18=(a18+a22);
  a22=(a12*a18);
  a23=(a08*a09);
  a24=(a04*a00);
  a23=(a23-a24);
  a24=(a10*a23);
  a22=(a22-a24);
  a24=(a02*a09);
  a25=(a10*a00);
  a24=(a24+a25);
  a24=(2.*a24);
  a25=(a02*a24);
  a22=(a22-a25);
  a09=(a13*a09);
  a25=(a04*a14);
  a09=(a09-a25);
  a00=(a12*a00);
  a14=(a02*a14);
  a00=(a00+a14);
  a00=(-a00);
  a00=(2.*a00);
  a09=(a09+a00);
  a00=(a06*a09);
  a22=(a22+a00);
  a22=(a15*a22);
  if (res[2]!=0) res[2][29]=a22;
  a22=(a10*a03);
  a00=(a02*a07);
  a14=(a06*a05);
  a00=(a00+a14);
  a22=(a22-a00);
  a00=(a12*a17);
  a22=(a22+a00);
  a22=(a15*a22);
  if (res[2]!=0) res[2][30]=a22;
  a22=(a10*a20);
  a00=(a02*a19);
  a14=(a06*a11);
  a00=(a00+a14);
  a22=(a22-a00);
  a00=(a12*a21);
  a22=(a22+a00);
  a22=(a15*a22);
  if (res[2]!=0) res[2][31]=a22;
  a22=(a10*a24);
  a00=(a02*a23);
  a14=(a06*a18);
  a00=(a00+a14);
  a22=(a22-a00);
  a00=(a12*a09);
  a22=(a22+a00);
  a22=(a15*a22);
  if (res[2]!=0) res[2][32]=a22;
  a05=(a02*a05);
  a07=(a06*a07);
  a05=(a05-a07);
  a03=(a12*a03);
  a05=(a05+a03);
  a17=(a10*a17);
  a05=(a05-a17);
  a05=(a15*a05);
  if (res[2]!=0) res[2][33]=a05;
  a11=(a02*a11);
  a19=(a06*a19);
  a11=(a11-a19);
  a20=(a12*a20);
  a11=(a11+a20);
  a21=(a10*a21);
  a11=(a11-a21);
  a11=(a15*a11);
  if (res[2]!=0) res[2][34]=a11;
  a18=(a02*a18);
  a23=(a06*a23);
  a18=(a18-a23);
  a24=(a12*a24);
  a18=(a18+a24);
  a09=(a10*a09);
  a18=(a18-a09);
  a15=(a15*a18);
  if (res[2]!=0) res[2][35]=a15;
  if (res[2]!=0) res[2][36]=a16;
  if (res[2]!=0) res[2][37]=a16;
  if (res[2]!=0) res[2][38]=a16;
  if (res[2]!=0) res[2][39]=a16;
  if (res[2]!=0) res[2][40]=a16;
  if (res[2]!=0) res[2][41]=a16;
  if (res[2]!=0) res[2][42]=a16;
  if (res[2]!=0) res[2][43]=a16;
  if (res[2]!=0) res[2][44]=a16;
  if (res[2]!=0) res[2][45]=a16;
  if (res[2]!=0) res[2][46]=a16;
  if (res[2]!=0) res[2][47]=a16;
  if (res[2]!=0) res[2][48]=a16;
  if (res[2]!=0) res[2][49]=a16;
  if (res[2]!=0) res[2][50]=a16;
  if (res[2]!=0) res[2][51]=a16;
  if (res[2]!=0) res[2][52]=a16;
  if (res[2]!=0) res[2][53]=a16;
  a16=(a04*a02);
  a15=(a01-a16);
  a06=(a13*a06);
  a15=(a15-a06);
  if (res[2]!=0) res[2][54]=a15;
  a15=(a13*a12);
  a18=(a04*a10);
  a09=(a15+a18);
  if (res[2]!=0) res[2][55]=a09;
  a09=(a13*a10);
  a04=(a04*a12);
  a24=(a09-a04);
  if (res[2]!=0) res[2][56]=a24;
  a18=(a18-a15);
  if (res[2]!=0) res[2][57]=a18;
  a10=(a08*a10);
  a18=(a01-a10);
  a18=(a18-a06);
  if (res[2]!=0) res[2][58]=a18;
  a08=(a08*a12);
  a13=(a13*a02);
  a02=(a08+a13);
  if (res[2]!=0) res[2][59]=a02;
  a04=(a04+a09);
  if (res[2]!=0) res[2][60]=a04;
  a13=(a13-a08);
  if (res[2]!=0) res[2][61]=a13;
  a01=(a01-a10);
  a01=(a01-a16);
  if (res[2]!=0) res[2][62]=a01;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_gps(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_gps_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_gps_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_gps_incref(void) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_gps_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_gps_casadi_gps_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_gps_casadi_gps_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real ekf_cal_gps_casadi_gps_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_gps_casadi_gps_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_gps_casadi_gps_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_gps_casadi_gps_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_gps_casadi_gps_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_gps_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_gps_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* ekf_cal_gps_casadi_gps_known_antenna:(i0[22],i1[3],i2[3])->(o0[3],o1[3],o2[3x21]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22;
  a00=1.;
  a01=arg[0]? arg[0][11] : 0;
  a02=(2.*a01);
  a03=(a02*a01);
  a04=(a00-a03);
  a05=arg[0]? arg[0][12] : 0;
  a06=(2.*a05);
  a07=(a06*a05);
  a04=(a04-a07);
  a08=arg[1]? arg[1][0] : 0;
  a04=(a04*a08);
  a09=arg[0]? arg[0][10] : 0;
  a10=(a02*a09);
  a11=arg[0]? arg[0][9] : 0;
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
  a15=arg[0]? arg[0][0] : 0;
  a04=(a04+a15);
  if (res[0]!=0) res[0][0]=a04;
  a12=(a12+a10);
  a12=(a12*a08);
  a10=(2.*a09);
  a15=(a10*a09);
  a17=(a00-a15);
  a17=(a17-a07);
  a17=(a17*a14);
  a12=(a12+a17);
  a06=(a06*a01);
  a10=(a10*a11);
  a17=(a06-a10);
  a17=(a17*a16);
  a12=(a12+a17);
  a17=arg[0]? arg[0][1] : 0;
  a12=(a12+a17);
  if (res[0]!=0) res[0][1]=a12;
  a13=(a13-a02);
  a13=(a13*a08);
  a10=(a10+a06);
  a10=(a10*a14);
  a13=(a13+a10);
  a15=(a00-a15);
  a15=(a15-a03);
  a15=(a15*a16);
  a13=(a13+a15);
  a15=arg[0]? arg[0][2] : 0;
  a13=(a13+a15);
  if (res[0]!=0) res[0][2]=a13;
  a15=arg[2]? arg[2][0] : 0;
  a15=(a15-a04);
  if (res[1]!=0) res[1][0]=a15;
  a15=arg[2]? arg[2][1] : 0;
  a15=(a15-a12);
  if (res[1]!=0) res[1][1]=a15;
  a15=arg[2]? arg[2][2] : 0;
  a15=(a15-a13);
  if (res[1]!=0) res[1][2]=a15;
  if (res[2]!=0) res[2][0]=a00;
  a15=0.;
  if (res[2]!=0) res[2][1]=a15;
  if (res[2]!=0) res[2][2]=a15;
  if (res[2]!=0) res[2][3]=a15;
  if (res[2]!=0) res[2][4]=a00;
  if (res[2]!=0) res[2][5]=a15;
  if (res[2]!=0) res[2][6]=a15;
  if (res[2]!=0) res[2][7]=a15;
  if (res[2]!=0) res[2][8]=a00;
  if (res[2]!=0) res[2][9]=a15;
  if (res[2]!=0) res[2][10]=a15;
  if (res[2]!=0) res[2][11]=a15;
  if (res[2]!=0) res[2][12]=a15;
  if (res[2]!=0) res[2][13]=a15;
  if (res[2]!=0) res[2][14]=a15;
  if (res[2]!=0) res[2][15]=a15;
  if (res[2]!=0) res[2][16]=a15;
  if (res[2]!=0) res[2][17]=a15;
  if (res[2]!=0) res[2][18]=a15;
  if (res[2]!=0) res[2][19]=a15;
  if (res[2]!=0) res[2][20]=a15;
  if (res[2]!=0) res[2][21]=a15;
  if (res[2]!=0) res[2][22]=a15;
  if (res[2]!=0) res[2][23]=a15;
  if (res[2]!=0) res[2][24]=a15;
  if (res[2]!=0) res[2][25]=a15;
  if (res[2]!=0) res[2][26]=a15;
  a00=(a09*a05);
  a13=(2.*a01);
  a12=5.0000000000000000e-01;
  a04=(a12*a11);
  a03=(a13*a04);
  a00=(a00+a03);
  a03=(a12*a01);
  a10=(-a03);
  a10=(2.*a10);
  a06=(a11*a10);
  a02=(2.*a05);
  a17=(a12*a09);
  a07=(a02*a17);
  a06=(a06-a07);
  a07=(a00-a06);
  a07=(a14*a07);
  a18=(a01*a05);
  a19=(a12*a05);
  a20=(a13*a19);
  a18=(a18+a20);
  a20=(a05*a10);
  a03=(a02*a03);
  a20=(a20-a03);
  a03=(a18+a20);
  a03=(a08*a03);
  a07=(a07-a03);
  a03=(a11*a05);
  a21=(a13*a17);
  a03=(a03-a21);
  a21=(a09*a10);
  a22=(a02*a04);
  a21=(a21+a22);
  a22=(a03+a21);
  a22=(a16*a22);
  a07=(a07+a22);
  if (res[2]!=0) res[2][27]=a07;
  a06=(a06+a00);
  a06=(a08*a06);
  a00=(a09*a11);
  a07=(2.*a09);
  a04=(a07*a04);
  a00=(a00+a04);
  a20=(a00+a20);
  a20=(a14*a20);
  a06=(a06-a20);
  a10=(a01*a10);
  a19=(a02*a19);
  a10=(a10+a19);
  a19=casadi_sq(a11);
  a17=(a07*a17);
  a19=(a19-a17);
  a17=(a10-a19);
  a17=(a16*a17);
  a06=(a06+a17);
  if (res[2]!=0) res[2][28]=a06;
  a21=(a21-a03);
  a21=(a08*a21);
  a19=(a19+a10);
  a19=(a14*a19);
  a21=(a21+a19);
  a00=(a00+a18);
  a00=(a16*a00);
  a21=(a21-a00);
  if (res[2]!=0) res[2][29]=a21;
  a21=(a09*a11);
  a00=(a12*a05);
  a18=(a13*a00);
  a21=(a21-a18);
  a18=(a11*a09);
  a19=(a12*a01);
  a10=(a02*a19);
  a18=(a18-a10);
  a10=(a21-a18);
  a10=(a14*a10);
  a03=(a01*a11);
  a06=(a12*a11);
  a17=(a13*a06);
  a03=(a03+a17);
  a17=(a05*a09);
  a20=(a12*a09);
  a20=(a02*a20);
  a17=(a17+a20);
  a20=(a03+a17);
  a20=(a08*a20);
  a10=(a10-a20);
  a20=casadi_sq(a11);
  a04=(a13*a19);
  a20=(a20-a04);
  a04=casadi_sq(a09);
  a22=(a02*a00);
  a04=(a04-a22);
  a22=(a20+a04);
  a22=(a16*a22);
  a10=(a10+a22);
  if (res[2]!=0) res[2][30]=a10;
  a18=(a18+a21);
  a18=(a08*a18);
  a21=(-a00);
  a21=(2.*a21);
  a10=(a09*a21);
  a00=(a07*a00);
  a10=(a10-a00);
  a17=(a10+a17);
  a17=(a14*a17);
  a18=(a18-a17);
  a17=(a01*a09);
  a06=(a02*a06);
  a17=(a17+a06);
  a21=(a11*a21);
  a19=(a07*a19);
  a21=(a21-a19);
  a19=(a17-a21);
  a19=(a16*a19);
  a18=(a18+a19);
  if (res[2]!=0) res[2][31]=a18;
  a04=(a04-a20);
  a04=(a08*a04);
  a21=(a21+a17);
  a21=(a14*a21);
  a04=(a04+a21);
  a10=(a10+a03);
  a10=(a16*a10);
  a04=(a04-a10);
  if (res[2]!=0) res[2][32]=a04;
  a04=(a12*a09);
  a10=(-a04);
  a10=(2.*a10);
  a03=(a09*a10);
  a21=(a12*a01);
  a17=(a13*a21);
  a03=(a03+a17);
  a17=casadi_sq(a11);
  a20=(a12*a05);
  a18=(a02*a20);
  a17=(a17-a18);
  a18=(a03-a17);
  a18=(a14*a18);
  a19=(a01*a10);
  a06=(a13*a04);
  a19=(a19-a06);
  a05=(a05*a11);
  a12=(a12*a11);
  a12=(a02*a12);
  a05=(a05+a12);
  a12=(a19+a05);
  a12=(a08*a12);
  a18=(a18-a12);
  a10=(a11*a10);
  a13=(a13*a20);
  a10=(a10-a13);
  a13=(a09*a11);
  a12=(a02*a21);
  a13=(a13+a12);
  a12=(a10+a13);
  a12=(a16*a12);
  a18=(a18+a12);
  if (res[2]!=0) res[2][33]=a18;
  a17=(a17+a03);
  a17=(a08*a17);
  a09=(a09*a01);
  a21=(a07*a21);
  a09=(a09+a21);
  a05=(a09+a05);
  a05=(a14*a05);
  a17=(a17-a05);
  a05=(a01*a11);
  a02=(a02*a04);
  a05=(a05-a02);
  a11=(a11*a01);
  a07=(a07*a20);
  a11=(a11-a07);
  a07=(a05-a11);
  a07=(a16*a07);
  a17=(a17+a07);
  if (res[2]!=0) res[2][34]=a17;
  a13=(a13-a10);
  a08=(a08*a13);
  a11=(a11+a05);
  a14=(a14*a11);
  a08=(a08+a14);
  a09=(a09+a19);
  a16=(a16*a09);
  a08=(a08-a16);
  if (res[2]!=0) res[2][35]=a08;
  if (res[2]!=0) res[2][36]=a15;
  if (res[2]!=0) res[2][37]=a15;
  if (res[2]!=0) res[2][38]=a15;
  if (res[2]!=0) res[2][39]=a15;
  if (res[2]!=0) res[2][40]=a15;
  if (res[2]!=0) res[2][41]=a15;
  if (res[2]!=0) res[2][42]=a15;
  if (res[2]!=0) res[2][43]=a15;
  if (res[2]!=0) res[2][44]=a15;
  if (res[2]!=0) res[2][45]=a15;
  if (res[2]!=0) res[2][46]=a15;
  if (res[2]!=0) res[2][47]=a15;
  if (res[2]!=0) res[2][48]=a15;
  if (res[2]!=0) res[2][49]=a15;
  if (res[2]!=0) res[2][50]=a15;
  if (res[2]!=0) res[2][51]=a15;
  if (res[2]!=0) res[2][52]=a15;
  if (res[2]!=0) res[2][53]=a15;
  if (res[2]!=0) res[2][54]=a15;
  if (res[2]!=0) res[2][55]=a15;
  if (res[2]!=0) res[2][56]=a15;
  if (res[2]!=0) res[2][57]=a15;
  if (res[2]!=0) res[2][58]=a15;
  if (res[2]!=0) res[2][59]=a15;
  if (res[2]!=0) res[2][60]=a15;
  if (res[2]!=0) res[2][61]=a15;
  if (res[2]!=0) res[2][62]=a15;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_gps_known_antenna(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_gps_known_antenna_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_gps_known_antenna_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_gps_known_antenna_incref(void) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_gps_known_antenna_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_gps_casadi_gps_known_antenna_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_gps_casadi_gps_known_antenna_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real ekf_cal_gps_casadi_gps_known_antenna_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_gps_casadi_gps_known_antenna_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_gps_casadi_gps_known_antenna_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_gps_casadi_gps_known_antenna_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_gps_casadi_gps_known_antenna_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_gps_known_antenna_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_gps_known_antenna_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* ekf_cal_gps_casadi_local_fix:(i0,i1[3],i2[3],i3[9])->(o0[3],o1[3x3],o2[9]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40;
  a00=arg[0]? arg[0][0] : 0;
  a01=cos(a00);
  a02=arg[1]? arg[1][0] : 0;
  a03=cos(a02);
  a04=arg[1]? arg[1][2] : 0;
  a05=6378137.;
  a06=1.;
  a07=6.6943799901413173e-03;
  a08=sin(a02);
  a08=casadi_sq(a08);
  a08=(a07*a08);
  a08=(a06-a08);
  a08=sqrt(a08);
  a09=(a05/a08);
  a10=(a04+a09);
  a03=(a03*a10);
  a10=(2.*a03);
  a11=5.0000000000000000e-01;
  a12=arg[1]? arg[1][1] : 0;
  a13=(a11*a12);
  a14=arg[2]? arg[2][1] : 0;
  a15=(a11*a14);
  a13=(a13-a15);
  a15=cos(a13);
  a10=(a10*a15);
  a13=sin(a13);
  a10=(a10*a13);
  a15=(a01*a10);
  a16=sin(a00);
  a17=arg[2]? arg[2][0] : 0;
  a18=cos(a17);
  a19=sin(a17);
  a20=arg[2]? arg[2][2] : 0;
  a20=(a04-a20);
  a21=9.9330562000985867e-01;
  a22=1.7079069082871987e+05;
  a23=casadi_sq(a19);
  a23=(a07*a23);
  a23=(a06-a23);
  a23=sqrt(a23);
  a24=(a08*a23);
  a08=(a08+a23);
  a24=(a24*a08);
  a24=(a22/a24);
  a08=(a11*a02);
  a23=(a11*a17);
  a08=(a08-a23);
  a23=cos(a08);
  a25=(a11*a02);
  a26=(a11*a17);
  a25=(a25+a26);
  a26=cos(a25);
  a23=(a23*a26);
  a08=sin(a08);
  a23=(a23*a08);
  a25=sin(a25);
  a23=(a23*a25);
  a24=(a24*a23);
  a23=(a21*a24);
  a23=(a20+a23);
  a23=(a19*a23);
  a26=(2.*a26);
  a27=(a21*a09);
  a27=(a04+a27);
  a26=(a26*a27);
  a26=(a26*a08);
  a23=(a23+a26);
  a26=(a18*a23);
  a20=(a20+a24);
  a20=(a18*a20);
  a08=(2.*a08);
  a08=(a08*a25);
  a09=(a04+a09);
  a08=(a08*a09);
  a20=(a20-a08);
  a13=casadi_sq(a13);
  a03=(a03*a13);
  a03=(2.*a03);
  a20=(a20-a03);
  a03=(a20*a19);
  a26=(a26-a03);
  a03=(a16*a26);
  a15=(a15-a03);
  if (res[0]!=0) res[0][0]=a15;
  a01=(a01*a26);
  a16=(a16*a10);
  a01=(a01+a16);
  if (res[0]!=0) res[0][1]=a01;
  a18=(a18*a20);
  a23=(a23*a19);
  a18=(a18+a23);
  if (res[0]!=0) res[0][2]=a18;
  a18=cos(a00);
  a23=(a11*a12);
  a19=(a11*a14);
  a23=(a23-a19);
  a19=sin(a23);
  a20=cos(a23);
  a01=cos(a02);
  a16=sin(a02);
  a10=casadi_sq(a16);
  a10=(a07*a10);
  a10=(a06-a10);
  a10=sqrt(a10);
  a26=(a05/a10);
  a15=(a26/a10);
  a16=(2.*a16);
  a03=cos(a02);
  a16=(a16*a03);
  a16=(a07*a16);
  a03=(2.*a10);
  a16=(a16/a03);
  a15=(a15*a16);
  a03=(a01*a15);
  a13=(a04+a26);
  a08=sin(a02);
  a08=(a13*a08);
  a03=(a03-a08);
  a08=(2.*a03);
  a08=(a20*a08);
  a08=(a19*a08);
  a09=(a18*a08);
  a25=sin(a00);
  a24=cos(a17);
  a27=sin(a17);
  a28=(a11*a02);
  a29=(a11*a17);
  a28=(a28-a29);
  a29=cos(a28);
  a30=(a11*a02);
  a31=(a11*a17);
  a30=(a30+a31);
  a31=cos(a30);
  a32=(a29*a31);
  a33=sin(a28);
  a34=(a32*a33);
  a35=sin(a30);
  a36=(a34*a35);
  a37=casadi_sq(a27);
  a37=(a07*a37);
  a37=(a06-a37);
  a37=sqrt(a37);
  a38=(a10*a37);
  a10=(a10+a37);
  a39=(a38*a10);
  a40=(a22/a39);
  a39=(a40/a39);
  a37=(a37*a16);
  a10=(a10*a37);
  a38=(a38*a16);
  a10=(a10+a38);
  a39=(a39*a10);
  a36=(a36*a39);
  a39=cos(a28);
  a10=(a11*a39);
  a32=(a32*a10);
  a28=sin(a28);
  a28=(a11*a28);
  a28=(a31*a28);
  a38=sin(a30);
  a38=(a11*a38);
  a29=(a29*a38);
  a28=(a28+a29);
  a28=(a33*a28);
  a32=(a32-a28);
  a32=(a35*a32);
  a30=cos(a30);
  a30=(a11*a30);
  a34=(a34*a30);
  a32=(a32+a34);
  a40=(a40*a32);
  a36=(a36+a40);
  a40=(a21*a36);
  a40=(a27*a40);
  a32=(a21*a26);
  a32=(a04+a32);
  a38=(-a38);
  a38=(2.*a38);
  a38=(a32*a38);
  a31=(2.*a31);
  a34=(a21*a15);
  a34=(a31*a34);
  a38=(a38+a34);
  a38=(a33*a38);
  a32=(a31*a32);
  a32=(a32*a10);
  a38=(a38+a32);
  a40=(a40+a38);
  a38=(a24*a40);
  a36=(a24*a36);
  a26=(a04+a26);
  a39=(a35*a39);
  a32=(2.*a33);
  a30=(a32*a30);
  a39=(a39+a30);
  a26=(a26*a39);
  a32=(a32*a35);
  a15=(a32*a15);
  a26=(a26+a15);
  a36=(a36-a26);
  a26=casadi_sq(a19);
  a03=(a26*a03);
  a03=(2.*a03);
  a36=(a36-a03);
  a03=(a27*a36);
  a38=(a38-a03);
  a03=(a25*a38);
  a09=(a09-a03);
  if (res[1]!=0) res[1][0]=a09;
  a38=(a18*a38);
  a08=(a25*a08);
  a38=(a38+a08);
  if (res[1]!=0) res[1][1]=a38;
  a36=(a24*a36);
  a40=(a27*a40);
  a36=(a36+a40);
  if (res[1]!=0) res[1][2]=a36;
  a13=(a01*a13);
  a36=(2.*a13);
  a40=(a36*a20);
  a38=cos(a23);
  a38=(a11*a38);
  a40=(a40*a38);
  a23=sin(a23);
  a23=(a11*a23);
  a36=(a36*a23);
  a36=(a19*a36);
  a40=(a40-a36);
  a36=(a18*a40);
  a23=(2.*a19);
  a23=(a23*a38);
  a13=(a13*a23);
  a13=(2.*a13);
  a23=(a27*a13);
  a38=(a25*a23);
  a36=(a36-a38);
  if (res[1]!=0) res[1][3]=a36;
  a23=(a18*a23);
  a40=(a25*a40);
  a23=(a23+a40);
  if (res[1]!=0) res[1][4]=a23;
  a13=(a24*a13);
  a13=(-a13);
  if (res[1]!=0) res[1][5]=a13;
  a13=(2.*a01);
  a20=(a20*a13);
  a19=(a19*a20);
  a20=(a18*a19);
  a33=(a33*a31);
  a33=(a27+a33);
  a31=(a24*a33);
  a32=(a24-a32);
  a26=(a26*a01);
  a26=(2.*a26);
  a32=(a32-a26);
  a26=(a27*a32);
  a31=(a31-a26);
  a26=(a25*a31);
  a20=(a20-a26);
  if (res[1]!=0) res[1][6]=a20;
  a18=(a18*a31);
  a25=(a25*a19);
  a18=(a18+a25);
  if (res[1]!=0) res[1][7]=a18;
  a24=(a24*a32);
  a27=(a27*a33);
  a24=(a24+a27);
  if (res[1]!=0) res[1][8]=a24;
  a24=cos(a00);
  a12=(a11*a12);
  a14=(a11*a14);
  a12=(a12-a14);
  a14=sin(a12);
  a27=cos(a12);
  a33=cos(a02);
  a32=sin(a02);
  a18=casadi_sq(a32);
  a18=(a07*a18);
  a18=(a06-a18);
  a18=sqrt(a18);
  a05=(a05/a18);
  a25=(a05/a18);
  a32=(2.*a32);
  a19=cos(a02);
  a32=(a32*a19);
  a32=(a07*a32);
  a19=(2.*a18);
  a32=(a32/a19);
  a25=(a25*a32);
  a19=(a33*a25);
  a31=(a04+a05);
  a20=sin(a02);
  a20=(a31*a20);
  a19=(a19-a20);
  a20=(2.*a19);
  a20=(a27*a20);
  a20=(a14*a20);
  a26=(a24*a20);
  a00=sin(a00);
  a01=cos(a17);
  a13=sin(a17);
  a23=(a11*a02);
  a40=(a11*a17);
  a23=(a23-a40);
  a40=cos(a23);
  a02=(a11*a02);
  a17=(a11*a17);
  a02=(a02+a17);
  a17=cos(a02);
  a36=(a40*a17);
  a38=sin(a23);
  a08=(a36*a38);
  a09=sin(a02);
  a03=(a08*a09);
  a15=casadi_sq(a13);
  a07=(a07*a15);
  a06=(a06-a07);
  a06=sqrt(a06);
  a07=(a18*a06);
  a18=(a18+a06);
  a15=(a07*a18);
  a22=(a22/a15);
  a15=(a22/a15);
  a06=(a06*a32);
  a18=(a18*a06);
  a07=(a07*a32);
  a18=(a18+a07);
  a15=(a15*a18);
  a03=(a03*a15);
  a15=cos(a23);
  a18=(a11*a15);
  a36=(a36*a18);
  a23=sin(a23);
  a23=(a11*a23);
  a23=(a17*a23);
  a07=sin(a02);
  a07=(a11*a07);
  a40=(a40*a07);
  a23=(a23+a40);
  a23=(a38*a23);
  a36=(a36-a23);
  a36=(a09*a36);
  a02=cos(a02);
  a02=(a11*a02);
  a08=(a08*a02);
  a36=(a36+a08);
  a22=(a22*a36);
  a03=(a03+a22);
  a22=(a21*a03);
  a22=(a13*a22);
  a36=(a21*a05);
  a36=(a04+a36);
  a07=(-a07);
  a07=(2.*a07);
  a07=(a36*a07);
  a17=(2.*a17);
  a21=(a21*a25);
  a21=(a17*a21);
  a07=(a07+a21);
  a07=(a38*a07);
  a36=(a17*a36);
  a36=(a36*a18);
  a07=(a07+a36);
  a22=(a22+a07);
  a07=(a01*a22);
  a03=(a01*a03);
  a04=(a04+a05);
  a15=(a09*a15);
  a05=(2.*a38);
  a02=(a05*a02);
  a15=(a15+a02);
  a04=(a04*a15);
  a05=(a05*a09);
  a25=(a05*a25);
  a04=(a04+a25);
  a03=(a03-a04);
  a04=casadi_sq(a14);
  a19=(a04*a19);
  a19=(2.*a19);
  a03=(a03-a19);
  a19=(a13*a03);
  a07=(a07-a19);
  a19=(a00*a07);
  a26=(a26-a19);
  a19=arg[3]? arg[3][0] : 0;
  a25=(a26*a19);
  a31=(a33*a31);
  a09=(2.*a31);
  a15=(a09*a27);
  a02=cos(a12);
  a02=(a11*a02);
  a15=(a15*a02);
  a12=sin(a12);
  a11=(a11*a12);
  a09=(a09*a11);
  a09=(a14*a09);
  a15=(a15-a09);
  a09=(a24*a15);
  a11=(2.*a14);
  a11=(a11*a02);
  a31=(a31*a11);
  a31=(2.*a31);
  a11=(a13*a31);
  a02=(a00*a11);
  a09=(a09-a02);
  a02=arg[3]? arg[3][3] : 0;
  a12=(a09*a02);
  a25=(a25+a12);
  a12=(2.*a33);
  a27=(a27*a12);
  a14=(a14*a27);
  a27=(a24*a14);
  a38=(a38*a17);
  a38=(a13+a38);
  a17=(a01*a38);
  a05=(a01-a05);
  a04=(a04*a33);
  a04=(2.*a04);
  a05=(a05-a04);
  a04=(a13*a05);
  a17=(a17-a04);
  a04=(a00*a17);
  a27=(a27-a04);
  a04=arg[3]? arg[3][6] : 0;
  a33=(a27*a04);
  a25=(a25+a33);
  a33=(a25*a26);
  a12=arg[3]? arg[3][1] : 0;
  a36=(a26*a12);
  a18=arg[3]? arg[3][4] : 0;
  a21=(a09*a18);
  a36=(a36+a21);
  a21=arg[3]? arg[3][7] : 0;
  a08=(a27*a21);
  a36=(a36+a08);
  a08=(a36*a09);
  a33=(a33+a08);
  a08=arg[3]? arg[3][2] : 0;
  a23=(a26*a08);
  a40=arg[3]? arg[3][5] : 0;
  a32=(a09*a40);
  a23=(a23+a32);
  a32=arg[3]? arg[3][8] : 0;
  a06=(a27*a32);
  a23=(a23+a06);
  a06=(a23*a27);
  a33=(a33+a06);
  if (res[2]!=0) res[2][0]=a33;
  a07=(a24*a07);
  a20=(a00*a20);
  a07=(a07+a20);
  a20=(a25*a07);
  a11=(a24*a11);
  a15=(a00*a15);
  a11=(a11+a15);
  a15=(a36*a11);
  a20=(a20+a15);
  a24=(a24*a17);
  a00=(a00*a14);
  a24=(a24+a00);
  a00=(a23*a24);
  a20=(a20+a00);
  if (res[2]!=0) res[2][1]=a20;
  a03=(a01*a03);
  a22=(a13*a22);
  a03=(a03+a22);
  a25=(a25*a03);
  a31=(a01*a31);
  a36=(a36*a31);
  a25=(a25-a36);
  a01=(a01*a05);
  a13=(a13*a38);
  a01=(a01+a13);
  a23=(a23*a01);
  a25=(a25+a23);
  if (res[2]!=0) res[2][2]=a25;
  a25=(a07*a19);
  a23=(a11*a02);
  a25=(a25+a23);
  a23=(a24*a04);
  a25=(a25+a23);
  a23=(a25*a26);
  a13=(a07*a12);
  a38=(a11*a18);
  a13=(a13+a38);
  a38=(a24*a21);
  a13=(a13+a38);
  a38=(a13*a09);
  a23=(a23+a38);
  a38=(a07*a08);
  a05=(a11*a40);
  a38=(a38+a05);
  a05=(a24*a32);
  a38=(a38+a05);
  a05=(a38*a27);
  a23=(a23+a05);
  if (res[2]!=0) res[2][3]=a23;
  a23=(a25*a07);
  a05=(a13*a11);
  a23=(a23+a05);
  a05=(a38*a24);
  a23=(a23+a05);
  if (res[2]!=0) res[2][4]=a23;
  a25=(a25*a03);
  a13=(a13*a31);
  a25=(a25-a13);
  a38=(a38*a01);
  a25=(a25+a38);
  if (res[2]!=0) res[2][5]=a25;
  a19=(a03*a19);
  a02=(a31*a02);
  a19=(a19-a02);
  a04=(a01*a04);
  a19=(a19+a04);
  a26=(a19*a26);
  a12=(a03*a12);
  a18=(a31*a18);
  a12=(a12-a18);
  a21=(a01*a21);
  a12=(a12+a21);
  a09=(a12*a09);
  a26=(a26+a09);
  a08=(a03*a08);
  a40=(a31*a40);
  a08=(a08-a40);
  a32=(a01*a32);
  a08=(a08+a32);
  a27=(a08*a27);
  a26=(a26+a27);
  if (res[2]!=0) res[2][6]=a26;
  a07=(a19*a07);
  a11=(a12*a11);
  a07=(a07+a11);
  a24=(a08*a24);
  a07=(a07+a24);
  if (res[2]!=0) res[2][7]=a07;
  a19=(a19*a03);
  a12=(a12*a31);
  a19=(a19-a12);
  a08=(a08*a01);
  a19=(a19+a08);
  if (res[2]!=0) res[2][8]=a19;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_local_fix(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f2(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_local_fix_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_local_fix_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_local_fix_incref(void) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_gps_casadi_local_fix_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_gps_casadi_local_fix_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_gps_casadi_local_fix_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real ekf_cal_gps_casadi_local_fix_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_gps_casadi_local_fix_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_gps_casadi_local_fix_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_gps_casadi_local_fix_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_gps_casadi_local_fix_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s5;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_local_fix_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_gps_casadi_local_fix_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


