/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ekf_cal_online_casadi_ ## ID
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
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)

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
CASADI_SYMBOL_EXPORT void ekf_cal_online_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {26, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {3, 25, 1};
static const casadi_int casadi_s3[3] = {3, 3, 1};

/* ekf_cal_online_casadi_gps_1:(i0[26],i1[3],i2[3])->(o0[3],o1[3],o2[3x25],o3[3x3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33;
  a00=arg[0]? arg[0][20] : 0;
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
  a09=arg[0]? arg[0][21] : 0;
  a10=arg[0]? arg[0][10] : 0;
  a11=(a03*a10);
  a12=arg[0]? arg[0][9] : 0;
  a13=(a07*a12);
  a14=(a11-a13);
  a14=(a09*a14);
  a05=(a05+a14);
  a14=arg[0]? arg[0][22] : 0;
  a03=(a03*a12);
  a15=(a07*a10);
  a16=(a03+a15);
  a16=(a14*a16);
  a05=(a05+a16);
  a16=arg[0]? arg[0][0] : 0;
  a05=(a05+a16);
  a17=arg[0]? arg[0][19] : 0;
  a18=cos(a17);
  a19=(a05*a18);
  a13=(a13+a11);
  a13=(a00*a13);
  a11=(2.*a10);
  a20=(a11*a10);
  a21=(a01-a20);
  a21=(a21-a08);
  a21=(a09*a21);
  a13=(a13+a21);
  a07=(a07*a02);
  a11=(a11*a12);
  a21=(a07-a11);
  a21=(a14*a21);
  a13=(a13+a21);
  a21=arg[0]? arg[0][1] : 0;
  a13=(a13+a21);
  a08=sin(a17);
  a22=(a13*a08);
  a19=(a19+a22);
  a22=arg[1]? arg[1][0] : 0;
  a19=(a19+a22);
  if (res[0]!=0) res[0][0]=a19;
  a13=(a13*a18);
  a05=(a05*a08);
  a13=(a13-a05);
  a05=arg[1]? arg[1][1] : 0;
  a13=(a13+a05);
  if (res[0]!=0) res[0][1]=a13;
  a15=(a15-a03);
  a15=(a00*a15);
  a11=(a11+a07);
  a11=(a09*a11);
  a15=(a15+a11);
  a20=(a01-a20);
  a20=(a20-a04);
  a20=(a14*a20);
  a15=(a15+a20);
  a20=arg[0]? arg[0][2] : 0;
  a15=(a15+a20);
  a20=arg[1]? arg[1][2] : 0;
  a15=(a15+a20);
  if (res[0]!=0) res[0][2]=a15;
  a20=arg[2]? arg[2][0] : 0;
  a20=(a20-a19);
  if (res[1]!=0) res[1][0]=a20;
  a20=arg[2]? arg[2][1] : 0;
  a20=(a20-a13);
  if (res[1]!=0) res[1][1]=a20;
  a20=arg[2]? arg[2][2] : 0;
  a20=(a20-a15);
  if (res[1]!=0) res[1][2]=a20;
  a20=6.2831853071795862e+00;
  a15=5.0000000000000000e-01;
  a13=1.5915494309189535e-01;
  a13=(a13*a17);
  a13=(a15-a13);
  a13=floor(a13);
  a20=(a20*a13);
  a17=(a17+a20);
  a20=cos(a17);
  if (res[2]!=0) res[2][0]=a20;
  a13=sin(a17);
  a19=(-a13);
  if (res[2]!=0) res[2][1]=a19;
  a19=0.;
  if (res[2]!=0) res[2][2]=a19;
  if (res[2]!=0) res[2][3]=a13;
  if (res[2]!=0) res[2][4]=a20;
  if (res[2]!=0) res[2][5]=a19;
  if (res[2]!=0) res[2][6]=a19;
  if (res[2]!=0) res[2][7]=a19;
  if (res[2]!=0) res[2][8]=a01;
  if (res[2]!=0) res[2][9]=a19;
  if (res[2]!=0) res[2][10]=a19;
  if (res[2]!=0) res[2][11]=a19;
  if (res[2]!=0) res[2][12]=a19;
  if (res[2]!=0) res[2][13]=a19;
  if (res[2]!=0) res[2][14]=a19;
  if (res[2]!=0) res[2][15]=a19;
  if (res[2]!=0) res[2][16]=a19;
  if (res[2]!=0) res[2][17]=a19;
  if (res[2]!=0) res[2][18]=a19;
  if (res[2]!=0) res[2][19]=a19;
  if (res[2]!=0) res[2][20]=a19;
  if (res[2]!=0) res[2][21]=a19;
  if (res[2]!=0) res[2][22]=a19;
  if (res[2]!=0) res[2][23]=a19;
  if (res[2]!=0) res[2][24]=a19;
  if (res[2]!=0) res[2][25]=a19;
  if (res[2]!=0) res[2][26]=a19;
  a04=(a14*a13);
  a11=(a12*a04);
  a07=(a09*a13);
  a03=(a10*a07);
  a11=(a11+a03);
  a11=(-a11);
  a11=(2.*a11);
  a03=(2.*a10);
  a05=(a03*a07);
  a11=(a11-a05);
  a05=(2.*a06);
  a08=(a14*a20);
  a18=(a05*a08);
  a11=(a11+a18);
  a18=(2.*a02);
  a22=(a00*a13);
  a23=(a09*a20);
  a24=(a22+a23);
  a25=(a18*a24);
  a11=(a11+a25);
  a25=(a12*a11);
  a26=(a18*a08);
  a27=(a03*a04);
  a26=(a26-a27);
  a22=(a22-a23);
  a23=(a05*a22);
  a26=(a26+a23);
  a23=(a10*a26);
  a25=(a25-a23);
  a23=(a02*a04);
  a27=(a10*a08);
  a23=(a23+a27);
  a22=(a12*a22);
  a23=(a23+a22);
  a22=(a00*a20);
  a07=(a07+a22);
  a27=(a06*a07);
  a23=(a23-a27);
  a23=(2.*a23);
  a07=(a05*a07);
  a23=(a23-a07);
  a07=(a02*a23);
  a25=(a25-a07);
  a04=(a05*a04);
  a07=(a18*a22);
  a04=(a04-a07);
  a08=(a12*a08);
  a24=(a10*a24);
  a08=(a08+a24);
  a22=(a02*a22);
  a08=(a08-a22);
  a08=(2.*a08);
  a04=(a04+a08);
  a08=(a06*a04);
  a25=(a25+a08);
  a25=(a15*a25);
  if (res[2]!=0) res[2][27]=a25;
  a25=(a14*a20);
  a08=(a12*a25);
  a22=(a09*a20);
  a24=(a10*a22);
  a08=(a08+a24);
  a08=(-a08);
  a08=(2.*a08);
  a24=(a03*a22);
  a08=(a08-a24);
  a24=(a14*a13);
  a07=(a05*a24);
  a08=(a08-a07);
  a07=(a00*a20);
  a27=(a09*a13);
  a28=(a07-a27);
  a29=(a18*a28);
  a08=(a08+a29);
  a29=(a12*a08);
  a07=(a07+a27);
  a27=(a05*a07);
  a30=(a03*a25);
  a31=(a18*a24);
  a30=(a30+a31);
  a27=(a27-a30);
  a30=(a10*a27);
  a29=(a29-a30);
  a30=(a00*a13);
  a22=(a30-a22);
  a31=(a05*a22);
  a32=(a02*a25);
  a33=(a10*a24);
  a32=(a32-a33);
  a07=(a12*a07);
  a32=(a32+a07);
  a22=(a06*a22);
  a32=(a32+a22);
  a32=(2.*a32);
  a31=(a31+a32);
  a32=(a02*a31);
  a29=(a29-a32);
  a25=(a05*a25);
  a32=(a18*a30);
  a25=(a25+a32);
  a28=(a10*a28);
  a24=(a12*a24);
  a28=(a28-a24);
  a30=(a02*a30);
  a28=(a28+a30);
  a28=(2.*a28);
  a25=(a25+a28);
  a28=(a06*a25);
  a29=(a29+a28);
  a29=(a15*a29);
  if (res[2]!=0) res[2][28]=a29;
  a29=(a12*a09);
  a28=(a10*a14);
  a29=(a29-a28);
  a29=(2.*a29);
  a28=(a03*a14);
  a29=(a29-a28);
  a28=(a05*a00);
  a29=(a29+a28);
  a28=(a12*a29);
  a30=(a03*a09);
  a24=(a18*a00);
  a30=(a30-a24);
  a24=(a10*a30);
  a28=(a28-a24);
  a24=(a02*a09);
  a32=(a10*a00);
  a24=(a24+a32);
  a24=(2.*a24);
  a32=(a02*a24);
  a28=(a28-a32);
  a32=(a05*a09);
  a22=(a18*a14);
  a32=(a32-a22);
  a22=(a12*a00);
  a07=(a02*a14);
  a22=(a22+a07);
  a22=(-a22);
  a22=(2.*a22);
  a32=(a32+a22);
  a22=(a06*a32);
  a28=(a28+a22);
  a28=(a15*a28);
  if (res[2]!=0) res[2][29]=a28;
  a28=(a10*a23);
  a22=(a02*a26);
  a07=(a06*a11);
  a22=(a22+a07);
  a28=(a28-a22);
  a22=(a12*a04);
  a28=(a28+a22);
  a28=(a15*a28);
  if (res[2]!=0) res[2][30]=a28;
  a28=(a10*a31);
  a22=(a02*a27);
  a07=(a06*a08);
  a22=(a22+a07);
  a28=(a28-a22);
  a22=(a12*a25);
  a28=(a28+a22);
  a28=(a15*a28);
  if (res[2]!=0) res[2][31]=a28;
  a28=(a10*a24);
  a22=(a02*a30);
  a07=(a06*a29);
  a22=(a22+a07);
  a28=(a28-a22);
  a22=(a12*a32);
  a28=(a28+a22);
  a28=(a15*a28);
  if (res[2]!=0) res[2][32]=a28;
  a11=(a02*a11);
  a26=(a06*a26);
  a11=(a11-a26);
  a23=(a12*a23);
  a11=(a11+a23);
  a04=(a10*a04);
  a11=(a11-a04);
  a11=(a15*a11);
  if (res[2]!=0) res[2][33]=a11;
  a08=(a02*a08);
  a27=(a06*a27);
  a08=(a08-a27);
  a31=(a12*a31);
  a08=(a08+a31);
  a25=(a10*a25);
  a08=(a08-a25);
  a08=(a15*a08);
  if (res[2]!=0) res[2][34]=a08;
  a29=(a02*a29);
  a30=(a06*a30);
  a29=(a29-a30);
  a24=(a12*a24);
  a29=(a29+a24);
  a32=(a10*a32);
  a29=(a29-a32);
  a15=(a15*a29);
  if (res[2]!=0) res[2][35]=a15;
  if (res[2]!=0) res[2][36]=a19;
  if (res[2]!=0) res[2][37]=a19;
  if (res[2]!=0) res[2][38]=a19;
  if (res[2]!=0) res[2][39]=a19;
  if (res[2]!=0) res[2][40]=a19;
  if (res[2]!=0) res[2][41]=a19;
  if (res[2]!=0) res[2][42]=a19;
  if (res[2]!=0) res[2][43]=a19;
  if (res[2]!=0) res[2][44]=a19;
  if (res[2]!=0) res[2][45]=a19;
  if (res[2]!=0) res[2][46]=a19;
  if (res[2]!=0) res[2][47]=a19;
  if (res[2]!=0) res[2][48]=a19;
  if (res[2]!=0) res[2][49]=a19;
  if (res[2]!=0) res[2][50]=a19;
  if (res[2]!=0) res[2][51]=a19;
  if (res[2]!=0) res[2][52]=a19;
  if (res[2]!=0) res[2][53]=a19;
  a15=cos(a17);
  a29=(a05*a12);
  a32=(a18*a10);
  a24=(a29+a32);
  a30=(a00*a24);
  a08=(a03*a10);
  a25=(a01-a08);
  a06=(a05*a06);
  a25=(a25-a06);
  a31=(a09*a25);
  a30=(a30+a31);
  a31=(a05*a02);
  a03=(a03*a12);
  a27=(a31-a03);
  a11=(a14*a27);
  a30=(a30+a11);
  a30=(a30+a21);
  a21=(a15*a30);
  a17=sin(a17);
  a02=(a18*a02);
  a11=(a01-a02);
  a11=(a11-a06);
  a00=(a00*a11);
  a32=(a32-a29);
  a09=(a09*a32);
  a00=(a00+a09);
  a18=(a18*a12);
  a05=(a05*a10);
  a10=(a18+a05);
  a14=(a14*a10);
  a00=(a00+a14);
  a00=(a00+a16);
  a16=(a17*a00);
  a21=(a21-a16);
  if (res[2]!=0) res[2][54]=a21;
  a15=(a15*a00);
  a17=(a17*a30);
  a15=(a15+a17);
  a15=(-a15);
  if (res[2]!=0) res[2][55]=a15;
  if (res[2]!=0) res[2][56]=a19;
  a15=(a24*a13);
  a17=(a11*a20);
  a15=(a15+a17);
  if (res[2]!=0) res[2][57]=a15;
  a24=(a24*a20);
  a11=(a11*a13);
  a24=(a24-a11);
  if (res[2]!=0) res[2][58]=a24;
  a05=(a05-a18);
  if (res[2]!=0) res[2][59]=a05;
  a05=(a25*a13);
  a18=(a32*a20);
  a05=(a05+a18);
  if (res[2]!=0) res[2][60]=a05;
  a25=(a25*a20);
  a32=(a32*a13);
  a25=(a25-a32);
  if (res[2]!=0) res[2][61]=a25;
  a03=(a03+a31);
  if (res[2]!=0) res[2][62]=a03;
  a03=(a27*a13);
  a31=(a10*a20);
  a03=(a03+a31);
  if (res[2]!=0) res[2][63]=a03;
  a27=(a27*a20);
  a10=(a10*a13);
  a27=(a27-a10);
  if (res[2]!=0) res[2][64]=a27;
  a08=(a01-a08);
  a08=(a08-a02);
  if (res[2]!=0) res[2][65]=a08;
  if (res[2]!=0) res[2][66]=a19;
  if (res[2]!=0) res[2][67]=a19;
  if (res[2]!=0) res[2][68]=a19;
  if (res[2]!=0) res[2][69]=a19;
  if (res[2]!=0) res[2][70]=a19;
  if (res[2]!=0) res[2][71]=a19;
  if (res[2]!=0) res[2][72]=a19;
  if (res[2]!=0) res[2][73]=a19;
  if (res[2]!=0) res[2][74]=a19;
  if (res[3]!=0) res[3][0]=a01;
  if (res[3]!=0) res[3][1]=a19;
  if (res[3]!=0) res[3][2]=a19;
  if (res[3]!=0) res[3][3]=a19;
  if (res[3]!=0) res[3][4]=a01;
  if (res[3]!=0) res[3][5]=a19;
  if (res[3]!=0) res[3][6]=a19;
  if (res[3]!=0) res[3][7]=a19;
  if (res[3]!=0) res[3][8]=a01;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_gps_1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_gps_1_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ekf_cal_online_casadi_gps_1_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_online_casadi_gps_1_incref(void) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_online_casadi_gps_1_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_online_casadi_gps_1_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_online_casadi_gps_1_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real ekf_cal_online_casadi_gps_1_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_online_casadi_gps_1_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_online_casadi_gps_1_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    case 3: return "o3";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_online_casadi_gps_1_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_online_casadi_gps_1_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_gps_1_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_gps_1_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* ekf_cal_online_casadi_gps_2:(i0[26],i1[3],i2[3])->(o0[3],o1[3],o2[3x25],o3[3x3]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33;
  a00=arg[0]? arg[0][23] : 0;
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
  a09=arg[0]? arg[0][24] : 0;
  a10=arg[0]? arg[0][10] : 0;
  a11=(a03*a10);
  a12=arg[0]? arg[0][9] : 0;
  a13=(a07*a12);
  a14=(a11-a13);
  a14=(a09*a14);
  a05=(a05+a14);
  a14=arg[0]? arg[0][25] : 0;
  a03=(a03*a12);
  a15=(a07*a10);
  a16=(a03+a15);
  a16=(a14*a16);
  a05=(a05+a16);
  a16=arg[0]? arg[0][0] : 0;
  a05=(a05+a16);
  a17=arg[0]? arg[0][19] : 0;
  a18=cos(a17);
  a19=(a05*a18);
  a13=(a13+a11);
  a13=(a00*a13);
  a11=(2.*a10);
  a20=(a11*a10);
  a21=(a01-a20);
  a21=(a21-a08);
  a21=(a09*a21);
  a13=(a13+a21);
  a07=(a07*a02);
  a11=(a11*a12);
  a21=(a07-a11);
  a21=(a14*a21);
  a13=(a13+a21);
  a21=arg[0]? arg[0][1] : 0;
  a13=(a13+a21);
  a08=sin(a17);
  a22=(a13*a08);
  a19=(a19+a22);
  a22=arg[1]? arg[1][0] : 0;
  a19=(a19+a22);
  if (res[0]!=0) res[0][0]=a19;
  a13=(a13*a18);
  a05=(a05*a08);
  a13=(a13-a05);
  a05=arg[1]? arg[1][1] : 0;
  a13=(a13+a05);
  if (res[0]!=0) res[0][1]=a13;
  a15=(a15-a03);
  a15=(a00*a15);
  a11=(a11+a07);
  a11=(a09*a11);
  a15=(a15+a11);
  a20=(a01-a20);
  a20=(a20-a04);
  a20=(a14*a20);
  a15=(a15+a20);
  a20=arg[0]? arg[0][2] : 0;
  a15=(a15+a20);
  a20=arg[1]? arg[1][2] : 0;
  a15=(a15+a20);
  if (res[0]!=0) res[0][2]=a15;
  a20=arg[2]? arg[2][0] : 0;
  a20=(a20-a19);
  if (res[1]!=0) res[1][0]=a20;
  a20=arg[2]? arg[2][1] : 0;
  a20=(a20-a13);
  if (res[1]!=0) res[1][1]=a20;
  a20=arg[2]? arg[2][2] : 0;
  a20=(a20-a15);
  if (res[1]!=0) res[1][2]=a20;
  a20=6.2831853071795862e+00;
  a15=5.0000000000000000e-01;
  a13=1.5915494309189535e-01;
  a13=(a13*a17);
  a13=(a15-a13);
  a13=floor(a13);
  a20=(a20*a13);
  a17=(a17+a20);
  a20=cos(a17);
  if (res[2]!=0) res[2][0]=a20;
  a13=sin(a17);
  a19=(-a13);
  if (res[2]!=0) res[2][1]=a19;
  a19=0.;
  if (res[2]!=0) res[2][2]=a19;
  if (res[2]!=0) res[2][3]=a13;
  if (res[2]!=0) res[2][4]=a20;
  if (res[2]!=0) res[2][5]=a19;
  if (res[2]!=0) res[2][6]=a19;
  if (res[2]!=0) res[2][7]=a19;
  if (res[2]!=0) res[2][8]=a01;
  if (res[2]!=0) res[2][9]=a19;
  if (res[2]!=0) res[2][10]=a19;
  if (res[2]!=0) res[2][11]=a19;
  if (res[2]!=0) res[2][12]=a19;
  if (res[2]!=0) res[2][13]=a19;
  if (res[2]!=0) res[2][14]=a19;
  if (res[2]!=0) res[2][15]=a19;
  if (res[2]!=0) res[2][16]=a19;
  if (res[2]!=0) res[2][17]=a19;
  if (res[2]!=0) res[2][18]=a19;
  if (res[2]!=0) res[2][19]=a19;
  if (res[2]!=0) res[2][20]=a19;
  if (res[2]!=0) res[2][21]=a19;
  if (res[2]!=0) res[2][22]=a19;
  if (res[2]!=0) res[2][23]=a19;
  if (res[2]!=0) res[2][24]=a19;
  if (res[2]!=0) res[2][25]=a19;
  if (res[2]!=0) res[2][26]=a19;
  a04=(a14*a13);
  a11=(a12*a04);
  a07=(a09*a13);
  a03=(a10*a07);
  a11=(a11+a03);
  a11=(-a11);
  a11=(2.*a11);
  a03=(2.*a10);
  a05=(a03*a07);
  a11=(a11-a05);
  a05=(2.*a06);
  a08=(a14*a20);
  a18=(a05*a08);
  a11=(a11+a18);
  a18=(2.*a02);
  a22=(a00*a13);
  a23=(a09*a20);
  a24=(a22+a23);
  a25=(a18*a24);
  a11=(a11+a25);
  a25=(a12*a11);
  a26=(a18*a08);
  a27=(a03*a04);
  a26=(a26-a27);
  a22=(a22-a23);
  a23=(a05*a22);
  a26=(a26+a23);
  a23=(a10*a26);
  a25=(a25-a23);
  a23=(a02*a04);
  a27=(a10*a08);
  a23=(a23+a27);
  a22=(a12*a22);
  a23=(a23+a22);
  a22=(a00*a20);
  a07=(a07+a22);
  a27=(a06*a07);
  a23=(a23-a27);
  a23=(2.*a23);
  a07=(a05*a07);
  a23=(a23-a07);
  a07=(a02*a23);
  a25=(a25-a07);
  a04=(a05*a04);
  a07=(a18*a22);
  a04=(a04-a07);
  a08=(a12*a08);
  a24=(a10*a24);
  a08=(a08+a24);
  a22=(a02*a22);
  a08=(a08-a22);
  a08=(2.*a08);
  a04=(a04+a08);
  a08=(a06*a04);
  a25=(a25+a08);
  a25=(a15*a25);
  if (res[2]!=0) res[2][27]=a25;
  a25=(a14*a20);
  a08=(a12*a25);
  a22=(a09*a20);
  a24=(a10*a22);
  a08=(a08+a24);
  a08=(-a08);
  a08=(2.*a08);
  a24=(a03*a22);
  a08=(a08-a24);
  a24=(a14*a13);
  a07=(a05*a24);
  a08=(a08-a07);
  a07=(a00*a20);
  a27=(a09*a13);
  a28=(a07-a27);
  a29=(a18*a28);
  a08=(a08+a29);
  a29=(a12*a08);
  a07=(a07+a27);
  a27=(a05*a07);
  a30=(a03*a25);
  a31=(a18*a24);
  a30=(a30+a31);
  a27=(a27-a30);
  a30=(a10*a27);
  a29=(a29-a30);
  a30=(a00*a13);
  a22=(a30-a22);
  a31=(a05*a22);
  a32=(a02*a25);
  a33=(a10*a24);
  a32=(a32-a33);
  a07=(a12*a07);
  a32=(a32+a07);
  a22=(a06*a22);
  a32=(a32+a22);
  a32=(2.*a32);
  a31=(a31+a32);
  a32=(a02*a31);
  a29=(a29-a32);
  a25=(a05*a25);
  a32=(a18*a30);
  a25=(a25+a32);
  a28=(a10*a28);
  a24=(a12*a24);
  a28=(a28-a24);
  a30=(a02*a30);
  a28=(a28+a30);
  a28=(2.*a28);
  a25=(a25+a28);
  a28=(a06*a25);
  a29=(a29+a28);
  a29=(a15*a29);
  if (res[2]!=0) res[2][28]=a29;
  a29=(a12*a09);
  a28=(a10*a14);
  a29=(a29-a28);
  a29=(2.*a29);
  a28=(a03*a14);
  a29=(a29-a28);
  a28=(a05*a00);
  a29=(a29+a28);
  a28=(a12*a29);
  a30=(a03*a09);
  a24=(a18*a00);
  a30=(a30-a24);
  a24=(a10*a30);
  a28=(a28-a24);
  a24=(a02*a09);
  a32=(a10*a00);
  a24=(a24+a32);
  a24=(2.*a24);
  a32=(a02*a24);
  a28=(a28-a32);
  a32=(a05*a09);
  a22=(a18*a14);
  a32=(a32-a22);
  a22=(a12*a00);
  a07=(a02*a14);
  a22=(a22+a07);
  a22=(-a22);
  a22=(2.*a22);
  a32=(a32+a22);
  a22=(a06*a32);
  a28=(a28+a22);
  a28=(a15*a28);
  if (res[2]!=0) res[2][29]=a28;
  a28=(a10*a23);
  a22=(a02*a26);
  a07=(a06*a11);
  a22=(a22+a07);
  a28=(a28-a22);
  a22=(a12*a04);
  a28=(a28+a22);
  a28=(a15*a28);
  if (res[2]!=0) res[2][30]=a28;
  a28=(a10*a31);
  a22=(a02*a27);
  a07=(a06*a08);
  a22=(a22+a07);
  a28=(a28-a22);
  a22=(a12*a25);
  a28=(a28+a22);
  a28=(a15*a28);
  if (res[2]!=0) res[2][31]=a28;
  a28=(a10*a24);
  a22=(a02*a30);
  a07=(a06*a29);
  a22=(a22+a07);
  a28=(a28-a22);
  a22=(a12*a32);
  a28=(a28+a22);
  a28=(a15*a28);
  if (res[2]!=0) res[2][32]=a28;
  a11=(a02*a11);
  a26=(a06*a26);
  a11=(a11-a26);
  a23=(a12*a23);
  a11=(a11+a23);
  a04=(a10*a04);
  a11=(a11-a04);
  a11=(a15*a11);
  if (res[2]!=0) res[2][33]=a11;
  a08=(a02*a08);
  a27=(a06*a27);
  a08=(a08-a27);
  a31=(a12*a31);
  a08=(a08+a31);
  a25=(a10*a25);
  a08=(a08-a25);
  a08=(a15*a08);
  if (res[2]!=0) res[2][34]=a08;
  a29=(a02*a29);
  a30=(a06*a30);
  a29=(a29-a30);
  a24=(a12*a24);
  a29=(a29+a24);
  a32=(a10*a32);
  a29=(a29-a32);
  a15=(a15*a29);
  if (res[2]!=0) res[2][35]=a15;
  if (res[2]!=0) res[2][36]=a19;
  if (res[2]!=0) res[2][37]=a19;
  if (res[2]!=0) res[2][38]=a19;
  if (res[2]!=0) res[2][39]=a19;
  if (res[2]!=0) res[2][40]=a19;
  if (res[2]!=0) res[2][41]=a19;
  if (res[2]!=0) res[2][42]=a19;
  if (res[2]!=0) res[2][43]=a19;
  if (res[2]!=0) res[2][44]=a19;
  if (res[2]!=0) res[2][45]=a19;
  if (res[2]!=0) res[2][46]=a19;
  if (res[2]!=0) res[2][47]=a19;
  if (res[2]!=0) res[2][48]=a19;
  if (res[2]!=0) res[2][49]=a19;
  if (res[2]!=0) res[2][50]=a19;
  if (res[2]!=0) res[2][51]=a19;
  if (res[2]!=0) res[2][52]=a19;
  if (res[2]!=0) res[2][53]=a19;
  a15=cos(a17);
  a29=(a05*a12);
  a32=(a18*a10);
  a24=(a29+a32);
  a30=(a00*a24);
  a08=(a03*a10);
  a25=(a01-a08);
  a06=(a05*a06);
  a25=(a25-a06);
  a31=(a09*a25);
  a30=(a30+a31);
  a31=(a05*a02);
  a03=(a03*a12);
  a27=(a31-a03);
  a11=(a14*a27);
  a30=(a30+a11);
  a30=(a30+a21);
  a21=(a15*a30);
  a17=sin(a17);
  a02=(a18*a02);
  a11=(a01-a02);
  a11=(a11-a06);
  a00=(a00*a11);
  a32=(a32-a29);
  a09=(a09*a32);
  a00=(a00+a09);
  a18=(a18*a12);
  a05=(a05*a10);
  a10=(a18+a05);
  a14=(a14*a10);
  a00=(a00+a14);
  a00=(a00+a16);
  a16=(a17*a00);
  a21=(a21-a16);
  if (res[2]!=0) res[2][54]=a21;
  a15=(a15*a00);
  a17=(a17*a30);
  a15=(a15+a17);
  a15=(-a15);
  if (res[2]!=0) res[2][55]=a15;
  if (res[2]!=0) res[2][56]=a19;
  if (res[2]!=0) res[2][57]=a19;
  if (res[2]!=0) res[2][58]=a19;
  if (res[2]!=0) res[2][59]=a19;
  if (res[2]!=0) res[2][60]=a19;
  if (res[2]!=0) res[2][61]=a19;
  if (res[2]!=0) res[2][62]=a19;
  if (res[2]!=0) res[2][63]=a19;
  if (res[2]!=0) res[2][64]=a19;
  if (res[2]!=0) res[2][65]=a19;
  a15=(a24*a13);
  a17=(a11*a20);
  a15=(a15+a17);
  if (res[2]!=0) res[2][66]=a15;
  a24=(a24*a20);
  a11=(a11*a13);
  a24=(a24-a11);
  if (res[2]!=0) res[2][67]=a24;
  a05=(a05-a18);
  if (res[2]!=0) res[2][68]=a05;
  a05=(a25*a13);
  a18=(a32*a20);
  a05=(a05+a18);
  if (res[2]!=0) res[2][69]=a05;
  a25=(a25*a20);
  a32=(a32*a13);
  a25=(a25-a32);
  if (res[2]!=0) res[2][70]=a25;
  a03=(a03+a31);
  if (res[2]!=0) res[2][71]=a03;
  a03=(a27*a13);
  a31=(a10*a20);
  a03=(a03+a31);
  if (res[2]!=0) res[2][72]=a03;
  a27=(a27*a20);
  a10=(a10*a13);
  a27=(a27-a10);
  if (res[2]!=0) res[2][73]=a27;
  a08=(a01-a08);
  a08=(a08-a02);
  if (res[2]!=0) res[2][74]=a08;
  if (res[3]!=0) res[3][0]=a01;
  if (res[3]!=0) res[3][1]=a19;
  if (res[3]!=0) res[3][2]=a19;
  if (res[3]!=0) res[3][3]=a19;
  if (res[3]!=0) res[3][4]=a01;
  if (res[3]!=0) res[3][5]=a19;
  if (res[3]!=0) res[3][6]=a19;
  if (res[3]!=0) res[3][7]=a19;
  if (res[3]!=0) res[3][8]=a01;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_gps_2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_gps_2_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ekf_cal_online_casadi_gps_2_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_online_casadi_gps_2_incref(void) {
}

CASADI_SYMBOL_EXPORT void ekf_cal_online_casadi_gps_2_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_online_casadi_gps_2_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int ekf_cal_online_casadi_gps_2_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real ekf_cal_online_casadi_gps_2_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_online_casadi_gps_2_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ekf_cal_online_casadi_gps_2_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    case 3: return "o3";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_online_casadi_gps_2_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ekf_cal_online_casadi_gps_2_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_gps_2_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ekf_cal_online_casadi_gps_2_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


