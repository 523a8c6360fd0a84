/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) rover_casadi_ ## ID
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
#define casadi_s6 CASADI_PREFIX(s6)
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
CASADI_SYMBOL_EXPORT void rover_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int rover_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int rover_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {22, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {3, 21, 1};
static const casadi_int casadi_s3[3] = {4, 1, 1};
static const casadi_int casadi_s4[3] = {1, 1, 1};
static const casadi_int casadi_s5[3] = {1, 21, 1};
static const casadi_int casadi_s6[3] = {6, 1, 1};

/* rover_casadi_gps:(i0[22])->(o0[3],o1[3x21]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25;
  a00=arg[0]? arg[0][16] : 0;
  a01=1.;
  a02=arg[0]? arg[0][8] : 0;
  a03=(2.*a02);
  a04=(a03*a02);
  a05=(a01-a04);
  a06=arg[0]? arg[0][9] : 0;
  a07=(2.*a06);
  a08=(a07*a06);
  a05=(a05-a08);
  a05=(a00*a05);
  a09=arg[0]? arg[0][17] : 0;
  a10=arg[0]? arg[0][7] : 0;
  a11=(a03*a10);
  a12=arg[0]? arg[0][6] : 0;
  a13=(a07*a12);
  a14=(a11-a13);
  a14=(a09*a14);
  a05=(a05+a14);
  a14=arg[0]? arg[0][18] : 0;
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
  a05=(a11*a10);
  a16=(a01-a05);
  a16=(a16-a08);
  a16=(a09*a16);
  a13=(a13+a16);
  a07=(a07*a02);
  a11=(a11*a12);
  a16=(a07-a11);
  a16=(a14*a16);
  a13=(a13+a16);
  a16=arg[0]? arg[0][1] : 0;
  a13=(a13+a16);
  if (res[0]!=0) res[0][1]=a13;
  a15=(a15-a03);
  a15=(a00*a15);
  a11=(a11+a07);
  a11=(a09*a11);
  a15=(a15+a11);
  a05=(a01-a05);
  a05=(a05-a04);
  a05=(a14*a05);
  a15=(a15+a05);
  a05=arg[0]? arg[0][2] : 0;
  a15=(a15+a05);
  if (res[0]!=0) res[0][2]=a15;
  if (res[1]!=0) res[1][0]=a01;
  a15=0.;
  if (res[1]!=0) res[1][1]=a15;
  if (res[1]!=0) res[1][2]=a15;
  if (res[1]!=0) res[1][3]=a15;
  if (res[1]!=0) res[1][4]=a01;
  if (res[1]!=0) res[1][5]=a15;
  if (res[1]!=0) res[1][6]=a15;
  if (res[1]!=0) res[1][7]=a15;
  if (res[1]!=0) res[1][8]=a01;
  if (res[1]!=0) res[1][9]=a15;
  if (res[1]!=0) res[1][10]=a15;
  if (res[1]!=0) res[1][11]=a15;
  if (res[1]!=0) res[1][12]=a15;
  if (res[1]!=0) res[1][13]=a15;
  if (res[1]!=0) res[1][14]=a15;
  if (res[1]!=0) res[1][15]=a15;
  if (res[1]!=0) res[1][16]=a15;
  if (res[1]!=0) res[1][17]=a15;
  a05=5.0000000000000000e-01;
  a04=(2.*a06);
  a11=(a04*a14);
  a07=(2.*a02);
  a03=(a07*a09);
  a11=(a11+a03);
  a03=(a12*a11);
  a13=(a07*a14);
  a16=(a04*a09);
  a13=(a13-a16);
  a16=(a10*a13);
  a03=(a03-a16);
  a16=(a10*a14);
  a08=(a12*a09);
  a16=(a16-a08);
  a08=(a06*a00);
  a16=(a16-a08);
  a16=(2.*a16);
  a08=(a04*a00);
  a16=(a16-a08);
  a08=(a02*a16);
  a03=(a03-a08);
  a08=(a12*a14);
  a17=(a10*a09);
  a08=(a08+a17);
  a17=(a02*a00);
  a08=(a08-a17);
  a08=(2.*a08);
  a17=(a07*a00);
  a08=(a08-a17);
  a17=(a06*a08);
  a03=(a03+a17);
  a03=(a05*a03);
  if (res[1]!=0) res[1][18]=a03;
  a03=(a12*a14);
  a17=(a10*a09);
  a03=(a03+a17);
  a03=(-a03);
  a03=(2.*a03);
  a17=(2.*a10);
  a18=(a17*a09);
  a03=(a03-a18);
  a18=(a07*a00);
  a03=(a03+a18);
  a18=(a12*a03);
  a19=(a04*a00);
  a20=(a17*a14);
  a19=(a19-a20);
  a20=(a10*a19);
  a18=(a18-a20);
  a20=(a02*a14);
  a21=(a12*a00);
  a20=(a20+a21);
  a21=(a06*a09);
  a20=(a20-a21);
  a20=(2.*a20);
  a21=(a04*a09);
  a20=(a20-a21);
  a21=(a02*a20);
  a18=(a18-a21);
  a21=(a04*a14);
  a22=(a10*a00);
  a22=(2.*a22);
  a21=(a21+a22);
  a22=(a06*a21);
  a18=(a18+a22);
  a18=(a05*a18);
  if (res[1]!=0) res[1][19]=a18;
  a18=(a12*a09);
  a22=(a10*a14);
  a18=(a18-a22);
  a18=(2.*a18);
  a22=(a17*a14);
  a18=(a18-a22);
  a22=(a04*a00);
  a18=(a18+a22);
  a22=(a12*a18);
  a23=(a17*a09);
  a24=(a07*a00);
  a23=(a23-a24);
  a24=(a10*a23);
  a22=(a22-a24);
  a24=(a02*a09);
  a25=(a10*a00);
  a24=(a24+a25);
  a24=(2.*a24);
  a25=(a02*a24);
  a22=(a22-a25);
  a09=(a04*a09);
  a25=(a07*a14);
  a09=(a09-a25);
  a00=(a12*a00);
  a14=(a02*a14);
  a00=(a00+a14);
  a00=(-a00);
  a00=(2.*a00);
  a09=(a09+a00);
  a00=(a06*a09);
  a22=(a22+a00);
  a22=(a05*a22);
  if (res[1]!=0) res[1][20]=a22;
  a22=(a10*a16);
  a00=(a02*a13);
  a14=(a06*a11);
  a00=(a00+a14);
  a22=(a22-a00);
  a00=(a12*a08);
  a22=(a22+a00);
  a22=(a05*a22);
  if (res[1]!=0) res[1][21]=a22;
  a22=(a10*a20);
  a00=(a02*a19);
  a14=(a06*a03);
  a00=(a00+a14);
  a22=(a22-a00);
  a00=(a12*a21);
  a22=(a22+a00);
  a22=(a05*a22);
  if (res[1]!=0) res[1][22]=a22;
  a22=(a10*a24);
  a00=(a02*a23);
  a14=(a06*a18);
  a00=(a00+a14);
  a22=(a22-a00);
  a00=(a12*a09);
  a22=(a22+a00);
  a22=(a05*a22);
  if (res[1]!=0) res[1][23]=a22;
  a11=(a02*a11);
  a13=(a06*a13);
  a11=(a11-a13);
  a16=(a12*a16);
  a11=(a11+a16);
  a08=(a10*a08);
  a11=(a11-a08);
  a11=(a05*a11);
  if (res[1]!=0) res[1][24]=a11;
  a03=(a02*a03);
  a19=(a06*a19);
  a03=(a03-a19);
  a20=(a12*a20);
  a03=(a03+a20);
  a21=(a10*a21);
  a03=(a03-a21);
  a03=(a05*a03);
  if (res[1]!=0) res[1][25]=a03;
  a18=(a02*a18);
  a23=(a06*a23);
  a18=(a18-a23);
  a24=(a12*a24);
  a18=(a18+a24);
  a09=(a10*a09);
  a18=(a18-a09);
  a05=(a05*a18);
  if (res[1]!=0) res[1][26]=a05;
  if (res[1]!=0) res[1][27]=a15;
  if (res[1]!=0) res[1][28]=a15;
  if (res[1]!=0) res[1][29]=a15;
  if (res[1]!=0) res[1][30]=a15;
  if (res[1]!=0) res[1][31]=a15;
  if (res[1]!=0) res[1][32]=a15;
  if (res[1]!=0) res[1][33]=a15;
  if (res[1]!=0) res[1][34]=a15;
  if (res[1]!=0) res[1][35]=a15;
  if (res[1]!=0) res[1][36]=a15;
  if (res[1]!=0) res[1][37]=a15;
  if (res[1]!=0) res[1][38]=a15;
  if (res[1]!=0) res[1][39]=a15;
  if (res[1]!=0) res[1][40]=a15;
  if (res[1]!=0) res[1][41]=a15;
  if (res[1]!=0) res[1][42]=a15;
  if (res[1]!=0) res[1][43]=a15;
  if (res[1]!=0) res[1][44]=a15;
  a05=(a07*a02);
  a18=(a01-a05);
  a06=(a04*a06);
  a18=(a18-a06);
  if (res[1]!=0) res[1][45]=a18;
  a18=(a04*a12);
  a09=(a07*a10);
  a24=(a18+a09);
  if (res[1]!=0) res[1][46]=a24;
  a24=(a04*a10);
  a07=(a07*a12);
  a23=(a24-a07);
  if (res[1]!=0) res[1][47]=a23;
  a09=(a09-a18);
  if (res[1]!=0) res[1][48]=a09;
  a10=(a17*a10);
  a09=(a01-a10);
  a09=(a09-a06);
  if (res[1]!=0) res[1][49]=a09;
  a17=(a17*a12);
  a04=(a04*a02);
  a02=(a17+a04);
  if (res[1]!=0) res[1][50]=a02;
  a07=(a07+a24);
  if (res[1]!=0) res[1][51]=a07;
  a04=(a04-a17);
  if (res[1]!=0) res[1][52]=a04;
  a01=(a01-a10);
  a01=(a01-a05);
  if (res[1]!=0) res[1][53]=a01;
  if (res[1]!=0) res[1][54]=a15;
  if (res[1]!=0) res[1][55]=a15;
  if (res[1]!=0) res[1][56]=a15;
  if (res[1]!=0) res[1][57]=a15;
  if (res[1]!=0) res[1][58]=a15;
  if (res[1]!=0) res[1][59]=a15;
  if (res[1]!=0) res[1][60]=a15;
  if (res[1]!=0) res[1][61]=a15;
  if (res[1]!=0) res[1][62]=a15;
  return 0;
}

CASADI_SYMBOL_EXPORT int rover_casadi_gps(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rover_casadi_gps_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rover_casadi_gps_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rover_casadi_gps_incref(void) {
}

CASADI_SYMBOL_EXPORT void rover_casadi_gps_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rover_casadi_gps_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int rover_casadi_gps_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rover_casadi_gps_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rover_casadi_gps_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rover_casadi_gps_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rover_casadi_gps_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rover_casadi_gps_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rover_casadi_gps_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int rover_casadi_gps_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* rover_casadi_range:(i0[22],i1[4],i2[3],i3,i4[3],i5,i6,i7,i8)->(o0,o1,o2[1x21]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49;
  a00=arg[3]? arg[3][0] : 0;
  a01=1.;
  a02=(a00==a01);
  a03=arg[0]? arg[0][20] : 0;
  a02=(a02?a03:0);
  a03=0.;
  a04=(a00==a03);
  a05=arg[0]? arg[0][19] : 0;
  a04=(a04?a05:0);
  a02=(a02+a04);
  a04=arg[7]? arg[7][0] : 0;
  a02=(a02+a04);
  a04=arg[0]? arg[0][16] : 0;
  a05=arg[0]? arg[0][8] : 0;
  a06=(2.*a05);
  a07=(a06*a05);
  a08=(a01-a07);
  a09=arg[0]? arg[0][9] : 0;
  a10=(2.*a09);
  a11=(a10*a09);
  a08=(a08-a11);
  a08=(a04*a08);
  a12=arg[0]? arg[0][17] : 0;
  a13=arg[0]? arg[0][7] : 0;
  a14=(a06*a13);
  a15=arg[0]? arg[0][6] : 0;
  a16=(a10*a15);
  a17=(a14-a16);
  a17=(a12*a17);
  a08=(a08+a17);
  a17=arg[0]? arg[0][18] : 0;
  a06=(a06*a15);
  a18=(a10*a13);
  a19=(a06+a18);
  a19=(a17*a19);
  a08=(a08+a19);
  a19=arg[0]? arg[0][0] : 0;
  a08=(a08+a19);
  a20=arg[1]? arg[1][2] : 0;
  a21=(2.*a20);
  a22=(a21*a20);
  a23=(a01-a22);
  a24=arg[1]? arg[1][3] : 0;
  a25=(2.*a24);
  a26=(a25*a24);
  a23=(a23-a26);
  a23=(a08*a23);
  a16=(a16+a14);
  a16=(a04*a16);
  a14=(2.*a13);
  a27=(a14*a13);
  a28=(a01-a27);
  a28=(a28-a11);
  a28=(a12*a28);
  a16=(a16+a28);
  a10=(a10*a05);
  a14=(a14*a15);
  a28=(a10-a14);
  a28=(a17*a28);
  a16=(a16+a28);
  a28=arg[0]? arg[0][1] : 0;
  a16=(a16+a28);
  a11=arg[1]? arg[1][1] : 0;
  a29=(a21*a11);
  a30=arg[1]? arg[1][0] : 0;
  a31=(a25*a30);
  a32=(a29-a31);
  a32=(a16*a32);
  a23=(a23+a32);
  a18=(a18-a06);
  a18=(a04*a18);
  a14=(a14+a10);
  a14=(a12*a14);
  a18=(a18+a14);
  a27=(a01-a27);
  a27=(a27-a07);
  a27=(a17*a27);
  a18=(a18+a27);
  a27=arg[0]? arg[0][2] : 0;
  a18=(a18+a27);
  a21=(a21*a30);
  a07=(a25*a11);
  a14=(a21+a07);
  a14=(a18*a14);
  a23=(a23+a14);
  a14=arg[2]? arg[2][0] : 0;
  a23=(a23+a14);
  a10=arg[4]? arg[4][0] : 0;
  a06=(a23-a10);
  a06=casadi_sq(a06);
  a31=(a31+a29);
  a31=(a08*a31);
  a29=(2.*a11);
  a32=(a29*a11);
  a33=(a01-a32);
  a33=(a33-a26);
  a33=(a16*a33);
  a31=(a31+a33);
  a25=(a25*a20);
  a29=(a29*a30);
  a33=(a25-a29);
  a33=(a18*a33);
  a31=(a31+a33);
  a33=arg[2]? arg[2][1] : 0;
  a31=(a31+a33);
  a26=arg[4]? arg[4][1] : 0;
  a34=(a31-a26);
  a34=casadi_sq(a34);
  a06=(a06+a34);
  a07=(a07-a21);
  a08=(a08*a07);
  a29=(a29+a25);
  a16=(a16*a29);
  a08=(a08+a16);
  a32=(a01-a32);
  a32=(a32-a22);
  a18=(a18*a32);
  a08=(a08+a18);
  a18=arg[2]? arg[2][2] : 0;
  a08=(a08+a18);
  a32=arg[4]? arg[4][2] : 0;
  a08=(a08-a32);
  a08=casadi_sq(a08);
  a06=(a06+a08);
  a06=sqrt(a06);
  a08=arg[6]? arg[6][0] : 0;
  a22=299792458.;
  a16=arg[5]? arg[5][0] : 0;
  a22=(a22*a16);
  a08=(a08-a22);
  a06=(a06+a08);
  a08=2.4323877909897254e-13;
  a22=(a08*a10);
  a31=(a31*a22);
  a22=(a08*a26);
  a23=(a23*a22);
  a31=(a31-a23);
  a06=(a06+a31);
  a02=(a02+a06);
  if (res[0]!=0) res[0][0]=a02;
  a06=arg[8]? arg[8][0] : 0;
  a06=(a06-a02);
  if (res[1]!=0) res[1][0]=a06;
  a06=(2.*a24);
  a02=(a06*a11);
  a31=(2.*a20);
  a23=(a31*a30);
  a22=(a02-a23);
  a16=(2.*a05);
  a29=(a16*a05);
  a25=(a01-a29);
  a07=(2.*a09);
  a21=(a07*a09);
  a25=(a25-a21);
  a34=(a04*a25);
  a35=(a16*a13);
  a36=(a07*a15);
  a37=(a35-a36);
  a38=(a12*a37);
  a34=(a34+a38);
  a38=(a16*a15);
  a39=(a07*a13);
  a40=(a38+a39);
  a41=(a17*a40);
  a34=(a34+a41);
  a34=(a34+a19);
  a19=(a34*a22);
  a36=(a36+a35);
  a35=(a04*a36);
  a41=(2.*a13);
  a42=(a41*a13);
  a43=(a01-a42);
  a43=(a43-a21);
  a21=(a12*a43);
  a35=(a35+a21);
  a21=(a07*a05);
  a44=(a41*a15);
  a45=(a21-a44);
  a46=(a17*a45);
  a35=(a35+a46);
  a35=(a35+a28);
  a28=(2.*a11);
  a46=(a28*a30);
  a47=(a06*a20);
  a48=(a46+a47);
  a49=(a35*a48);
  a19=(a19+a49);
  a39=(a39-a38);
  a38=(a04*a39);
  a44=(a44+a21);
  a21=(a12*a44);
  a38=(a38+a21);
  a42=(a01-a42);
  a42=(a42-a29);
  a29=(a17*a42);
  a38=(a38+a29);
  a38=(a38+a27);
  a28=(a28*a11);
  a27=(a01-a28);
  a20=(a31*a20);
  a27=(a27-a20);
  a29=(a38*a27);
  a19=(a19+a29);
  a19=(a19+a18);
  a19=(a19-a32);
  a20=(a01-a20);
  a24=(a06*a24);
  a20=(a20-a24);
  a32=(a34*a20);
  a31=(a31*a11);
  a06=(a06*a30);
  a30=(a31-a06);
  a11=(a35*a30);
  a32=(a32+a11);
  a23=(a23+a02);
  a02=(a38*a23);
  a32=(a32+a02);
  a32=(a32+a14);
  a32=(a32-a10);
  a14=casadi_sq(a32);
  a06=(a06+a31);
  a34=(a34*a06);
  a28=(a01-a28);
  a28=(a28-a24);
  a35=(a35*a28);
  a34=(a34+a35);
  a47=(a47-a46);
  a38=(a38*a47);
  a34=(a34+a38);
  a34=(a34+a33);
  a34=(a34-a26);
  a33=casadi_sq(a34);
  a14=(a14+a33);
  a33=casadi_sq(a19);
  a14=(a14+a33);
  a14=sqrt(a14);
  a19=(a19/a14);
  a22=(a22*a19);
  a10=(a08*a10);
  a34=(a34/a14);
  a10=(a10+a34);
  a06=(a06*a10);
  a22=(a22+a06);
  a32=(a32/a14);
  a08=(a08*a26);
  a32=(a32-a08);
  a20=(a20*a32);
  a22=(a22+a20);
  if (res[2]!=0) res[2][0]=a22;
  a48=(a48*a19);
  a28=(a28*a10);
  a48=(a48+a28);
  a30=(a30*a32);
  a48=(a48+a30);
  if (res[2]!=0) res[2][1]=a48;
  a27=(a27*a19);
  a47=(a47*a10);
  a27=(a27+a47);
  a23=(a23*a32);
  a27=(a27+a23);
  if (res[2]!=0) res[2][2]=a27;
  if (res[2]!=0) res[2][3]=a03;
  if (res[2]!=0) res[2][4]=a03;
  if (res[2]!=0) res[2][5]=a03;
  a23=5.0000000000000000e-01;
  a32=(a12*a27);
  a47=(a17*a48);
  a10=(a32-a47);
  a19=(a15*a10);
  a30=(a17*a27);
  a28=(a12*a48);
  a20=(a30+a28);
  a08=(a13*a20);
  a19=(a19-a08);
  a19=(2.*a19);
  a20=(a41*a20);
  a19=(a19-a20);
  a20=(a04*a27);
  a17=(a17*a22);
  a08=(a20+a17);
  a26=(a07*a08);
  a19=(a19+a26);
  a26=(a04*a48);
  a12=(a12*a22);
  a14=(a26+a12);
  a06=(a16*a14);
  a19=(a19+a06);
  a06=(a15*a19);
  a41=(a41*a10);
  a17=(a17-a20);
  a20=(a16*a17);
  a41=(a41+a20);
  a26=(a26-a12);
  a12=(a07*a26);
  a41=(a41+a12);
  a12=(a13*a41);
  a06=(a06-a12);
  a32=(a32+a47);
  a47=(a05*a32);
  a08=(a13*a08);
  a47=(a47+a08);
  a26=(a15*a26);
  a47=(a47+a26);
  a04=(a04*a22);
  a28=(a28+a04);
  a26=(a09*a28);
  a47=(a47-a26);
  a47=(2.*a47);
  a28=(a07*a28);
  a47=(a47-a28);
  a28=(a05*a47);
  a06=(a06-a28);
  a07=(a07*a32);
  a30=(a30+a04);
  a16=(a16*a30);
  a07=(a07-a16);
  a17=(a15*a17);
  a14=(a13*a14);
  a17=(a17+a14);
  a30=(a05*a30);
  a17=(a17-a30);
  a17=(2.*a17);
  a07=(a07+a17);
  a17=(a09*a07);
  a06=(a06+a17);
  a06=(a23*a06);
  if (res[2]!=0) res[2][6]=a06;
  a06=(a13*a47);
  a17=(a05*a41);
  a30=(a09*a19);
  a17=(a17+a30);
  a06=(a06-a17);
  a17=(a15*a07);
  a06=(a06+a17);
  a06=(a23*a06);
  if (res[2]!=0) res[2][7]=a06;
  a05=(a05*a19);
  a09=(a09*a41);
  a05=(a05-a09);
  a15=(a15*a47);
  a05=(a05+a15);
  a13=(a13*a07);
  a05=(a05-a13);
  a23=(a23*a05);
  if (res[2]!=0) res[2][8]=a23;
  if (res[2]!=0) res[2][9]=a03;
  if (res[2]!=0) res[2][10]=a03;
  if (res[2]!=0) res[2][11]=a03;
  if (res[2]!=0) res[2][12]=a03;
  if (res[2]!=0) res[2][13]=a03;
  if (res[2]!=0) res[2][14]=a03;
  a39=(a39*a27);
  a36=(a36*a48);
  a39=(a39+a36);
  a25=(a25*a22);
  a39=(a39+a25);
  if (res[2]!=0) res[2][15]=a39;
  a44=(a44*a27);
  a43=(a43*a48);
  a44=(a44+a43);
  a37=(a37*a22);
  a44=(a44+a37);
  if (res[2]!=0) res[2][16]=a44;
  a42=(a42*a27);
  a45=(a45*a48);
  a42=(a42+a45);
  a40=(a40*a22);
  a42=(a42+a40);
  if (res[2]!=0) res[2][17]=a42;
  a42=(a00==a03);
  a42=(a42?a01:0);
  if (res[2]!=0) res[2][18]=a42;
  a00=(a00==a01);
  a00=(a00?a01:0);
  if (res[2]!=0) res[2][19]=a00;
  if (res[2]!=0) res[2][20]=a03;
  return 0;
}

CASADI_SYMBOL_EXPORT int rover_casadi_range(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rover_casadi_range_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rover_casadi_range_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rover_casadi_range_incref(void) {
}

CASADI_SYMBOL_EXPORT void rover_casadi_range_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rover_casadi_range_n_in(void) { return 9;}

CASADI_SYMBOL_EXPORT casadi_int rover_casadi_range_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real rover_casadi_range_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rover_casadi_range_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    case 4: return "i4";
    case 5: return "i5";
    case 6: return "i6";
    case 7: return "i7";
    case 8: return "i8";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rover_casadi_range_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rover_casadi_range_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s3;
    case 2: return casadi_s1;
    case 3: return casadi_s4;
    case 4: return casadi_s1;
    case 5: return casadi_s4;
    case 6: return casadi_s4;
    case 7: return casadi_s4;
    case 8: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rover_casadi_range_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s4;
    case 2: return casadi_s5;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rover_casadi_range_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int rover_casadi_range_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* rover_casadi_imu:(i0[22],i1[6],i2[6],i3)->(o0[3],o1[3x21]) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52;
  a00=1.;
  a01=arg[0]? arg[0][8] : 0;
  a02=(2.*a01);
  a03=(a02*a01);
  a04=(a00-a03);
  a05=arg[0]? arg[0][9] : 0;
  a06=(2.*a05);
  a07=(a06*a05);
  a04=(a04-a07);
  a08=arg[2]? arg[2][0] : 0;
  a09=arg[0]? arg[0][10] : 0;
  a10=5.0000000000000000e-01;
  a11=arg[3]? arg[3][0] : 0;
  a12=(a10*a11);
  a13=(a09*a12);
  a14=(a08-a13);
  a15=arg[2]? arg[2][3] : 0;
  a13=(a15-a13);
  a16=(a14+a13);
  a17=arg[1]? arg[1][5] : 0;
  a18=(a10*a11);
  a19=arg[0]? arg[0][15] : 0;
  a20=(a18*a19);
  a21=(a17-a20);
  a22=6.6666666666666663e-01;
  a23=arg[2]? arg[2][1] : 0;
  a24=arg[0]? arg[0][11] : 0;
  a25=(a24*a12);
  a26=(a23-a25);
  a27=(a22*a26);
  a28=(a21*a27);
  a29=arg[1]? arg[1][4] : 0;
  a30=arg[0]? arg[0][14] : 0;
  a31=(a18*a30);
  a32=(a29-a31);
  a33=arg[2]? arg[2][2] : 0;
  a34=arg[0]? arg[0][12] : 0;
  a12=(a34*a12);
  a35=(a33-a12);
  a36=(a22*a35);
  a37=(a32*a36);
  a28=(a28-a37);
  a28=(a16+a28);
  a37=arg[1]? arg[1][1] : 0;
  a31=(a37-a31);
  a38=(a31+a32);
  a38=(a10*a38);
  a39=arg[2]? arg[2][5] : 0;
  a12=(a39-a12);
  a35=(a35+a12);
  a40=(a38*a35);
  a41=arg[1]? arg[1][2] : 0;
  a20=(a41-a20);
  a42=(a20+a21);
  a42=(a10*a42);
  a43=arg[2]? arg[2][4] : 0;
  a25=(a43-a25);
  a26=(a26+a25);
  a44=(a42*a26);
  a40=(a40-a44);
  a31=(a22*a31);
  a44=(a31*a12);
  a20=(a22*a20);
  a45=(a20*a25);
  a44=(a44-a45);
  a40=(a40+a44);
  a28=(a28+a40);
  a28=(a28/a11);
  a04=(a04*a28);
  a40=arg[0]? arg[0][7] : 0;
  a44=(a02*a40);
  a45=arg[0]? arg[0][6] : 0;
  a46=(a06*a45);
  a47=(a44-a46);
  a48=arg[1]? arg[1][3] : 0;
  a49=arg[0]? arg[0][13] : 0;
  a18=(a18*a49);
  a50=(a48-a18);
  a36=(a50*a36);
  a14=(a22*a14);
  a21=(a21*a14);
  a36=(a36-a21);
  a36=(a26+a36);
  a42=(a42*a16);
  a21=arg[1]? arg[1][0] : 0;
  a18=(a21-a18);
  a51=(a18+a50);
  a51=(a10*a51);
  a52=(a51*a35);
  a42=(a42-a52);
  a20=(a20*a13);
  a18=(a22*a18);
  a12=(a18*a12);
  a20=(a20-a12);
  a42=(a42+a20);
  a36=(a36+a42);
  a36=(a36/a11);
  a47=(a47*a36);
  a04=(a04+a47);
  a02=(a02*a45);
  a47=(a06*a40);
  a42=(a02+a47);
  a32=(a32*a14);
  a50=(a50*a27);
  a32=(a32-a50);
  a35=(a35+a32);
  a51=(a51*a26);
  a38=(a38*a16);
  a51=(a51-a38);
  a18=(a18*a25);
  a31=(a31*a13);
  a18=(a18-a31);
  a51=(a51+a18);
  a35=(a35+a51);
  a35=(a35/a11);
  a42=(a42*a35);
  a04=(a04+a42);
  if (res[0]!=0) res[0][0]=a04;
  a46=(a46+a44);
  a46=(a46*a28);
  a44=(2.*a40);
  a04=(a44*a40);
  a42=(a00-a04);
  a42=(a42-a07);
  a42=(a42*a36);
  a46=(a46+a42);
  a06=(a06*a01);
  a44=(a44*a45);
  a42=(a06-a44);
  a42=(a42*a35);
  a46=(a46+a42);
  if (res[0]!=0) res[0][1]=a46;
  a47=(a47-a02);
  a47=(a47*a28);
  a44=(a44+a06);
  a44=(a44*a36);
  a47=(a47+a44);
  a04=(a00-a04);
  a04=(a04-a03);
  a04=(a04*a35);
  a47=(a47+a04);
  if (res[0]!=0) res[0][2]=a47;
  a47=0.;
  if (res[1]!=0) res[1][0]=a47;
  if (res[1]!=0) res[1][1]=a47;
  if (res[1]!=0) res[1][2]=a47;
  if (res[1]!=0) res[1][3]=a47;
  if (res[1]!=0) res[1][4]=a47;
  if (res[1]!=0) res[1][5]=a47;
  if (res[1]!=0) res[1][6]=a47;
  if (res[1]!=0) res[1][7]=a47;
  if (res[1]!=0) res[1][8]=a47;
  if (res[1]!=0) res[1][9]=a47;
  if (res[1]!=0) res[1][10]=a47;
  if (res[1]!=0) res[1][11]=a47;
  if (res[1]!=0) res[1][12]=a47;
  if (res[1]!=0) res[1][13]=a47;
  if (res[1]!=0) res[1][14]=a47;
  if (res[1]!=0) res[1][15]=a47;
  if (res[1]!=0) res[1][16]=a47;
  if (res[1]!=0) res[1][17]=a47;
  a04=(2.*a05);
  a35=(a10*a11);
  a34=(a34*a35);
  a33=(a33-a34);
  a39=(a39-a34);
  a34=(a33+a39);
  a03=(a10*a11);
  a30=(a03*a30);
  a29=(a29-a30);
  a09=(a09*a35);
  a08=(a08-a09);
  a44=(a22*a08);
  a36=(a29*a44);
  a49=(a03*a49);
  a48=(a48-a49);
  a24=(a24*a35);
  a23=(a23-a24);
  a06=(a22*a23);
  a28=(a48*a06);
  a36=(a36-a28);
  a36=(a34+a36);
  a21=(a21-a49);
  a49=(a21+a48);
  a49=(a10*a49);
  a43=(a43-a24);
  a23=(a23+a43);
  a24=(a49*a23);
  a37=(a37-a30);
  a30=(a37+a29);
  a30=(a10*a30);
  a15=(a15-a09);
  a08=(a08+a15);
  a09=(a30*a08);
  a24=(a24-a09);
  a21=(a22*a21);
  a09=(a21*a43);
  a37=(a22*a37);
  a28=(a37*a15);
  a09=(a09-a28);
  a24=(a24+a09);
  a36=(a36+a24);
  a36=(a36/a11);
  a24=(a04*a36);
  a09=(2.*a01);
  a33=(a22*a33);
  a28=(a48*a33);
  a19=(a03*a19);
  a17=(a17-a19);
  a02=(a17*a44);
  a28=(a28-a02);
  a28=(a23+a28);
  a41=(a41-a19);
  a19=(a41+a17);
  a19=(a10*a19);
  a02=(a19*a08);
  a46=(a49*a34);
  a02=(a02-a46);
  a41=(a22*a41);
  a46=(a41*a15);
  a42=(a21*a39);
  a46=(a46-a42);
  a02=(a02+a46);
  a28=(a28+a02);
  a28=(a28/a11);
  a02=(a09*a28);
  a24=(a24+a02);
  a02=(a45*a24);
  a46=(a09*a36);
  a42=(a04*a28);
  a46=(a46-a42);
  a42=(a40*a46);
  a02=(a02-a42);
  a42=(a40*a36);
  a07=(a45*a28);
  a42=(a42-a07);
  a07=(a17*a06);
  a51=(a29*a33);
  a07=(a07-a51);
  a07=(a08+a07);
  a51=(a30*a34);
  a18=(a19*a23);
  a51=(a51-a18);
  a18=(a37*a39);
  a31=(a41*a43);
  a18=(a18-a31);
  a51=(a51+a18);
  a07=(a07+a51);
  a07=(a07/a11);
  a51=(a05*a07);
  a42=(a42-a51);
  a42=(2.*a42);
  a51=(a04*a07);
  a42=(a42-a51);
  a51=(a01*a42);
  a02=(a02-a51);
  a51=(a45*a36);
  a18=(a40*a28);
  a51=(a51+a18);
  a18=(a01*a07);
  a51=(a51-a18);
  a51=(2.*a51);
  a18=(a09*a07);
  a51=(a51-a18);
  a18=(a05*a51);
  a02=(a02+a18);
  a02=(a10*a02);
  if (res[1]!=0) res[1][18]=a02;
  a02=(a45*a36);
  a18=(a40*a28);
  a02=(a02+a18);
  a02=(-a02);
  a02=(2.*a02);
  a18=(2.*a40);
  a31=(a18*a28);
  a02=(a02-a31);
  a31=(a09*a07);
  a02=(a02+a31);
  a31=(a45*a02);
  a13=(a04*a07);
  a25=(a18*a36);
  a13=(a13-a25);
  a25=(a40*a13);
  a31=(a31-a25);
  a25=(a01*a36);
  a38=(a45*a07);
  a25=(a25+a38);
  a38=(a05*a28);
  a25=(a25-a38);
  a25=(2.*a25);
  a38=(a04*a28);
  a25=(a25-a38);
  a38=(a01*a25);
  a31=(a31-a38);
  a38=(a04*a36);
  a16=(a40*a07);
  a16=(2.*a16);
  a38=(a38+a16);
  a16=(a05*a38);
  a31=(a31+a16);
  a31=(a10*a31);
  if (res[1]!=0) res[1][19]=a31;
  a31=(a45*a28);
  a16=(a40*a36);
  a31=(a31-a16);
  a31=(2.*a31);
  a16=(a18*a36);
  a31=(a31-a16);
  a16=(a04*a07);
  a31=(a31+a16);
  a16=(a45*a31);
  a26=(a18*a28);
  a32=(a09*a07);
  a26=(a26-a32);
  a32=(a40*a26);
  a16=(a16-a32);
  a32=(a01*a28);
  a50=(a40*a07);
  a32=(a32+a50);
  a32=(2.*a32);
  a50=(a01*a32);
  a16=(a16-a50);
  a28=(a04*a28);
  a50=(a09*a36);
  a28=(a28-a50);
  a07=(a45*a07);
  a36=(a01*a36);
  a07=(a07+a36);
  a07=(-a07);
  a07=(2.*a07);
  a28=(a28+a07);
  a07=(a05*a28);
  a16=(a16+a07);
  a16=(a10*a16);
  if (res[1]!=0) res[1][20]=a16;
  a16=(a40*a42);
  a07=(a01*a46);
  a36=(a05*a24);
  a07=(a07+a36);
  a16=(a16-a07);
  a07=(a45*a51);
  a16=(a16+a07);
  a16=(a10*a16);
  if (res[1]!=0) res[1][21]=a16;
  a16=(a40*a25);
  a07=(a01*a13);
  a36=(a05*a02);
  a07=(a07+a36);
  a16=(a16-a07);
  a07=(a45*a38);
  a16=(a16+a07);
  a16=(a10*a16);
  if (res[1]!=0) res[1][22]=a16;
  a16=(a40*a32);
  a07=(a01*a26);
  a36=(a05*a31);
  a07=(a07+a36);
  a16=(a16-a07);
  a07=(a45*a28);
  a16=(a16+a07);
  a16=(a10*a16);
  if (res[1]!=0) res[1][23]=a16;
  a24=(a01*a24);
  a46=(a05*a46);
  a24=(a24-a46);
  a42=(a45*a42);
  a24=(a24+a42);
  a51=(a40*a51);
  a24=(a24-a51);
  a24=(a10*a24);
  if (res[1]!=0) res[1][24]=a24;
  a02=(a01*a02);
  a13=(a05*a13);
  a02=(a02-a13);
  a25=(a45*a25);
  a02=(a02+a25);
  a38=(a40*a38);
  a02=(a02-a38);
  a02=(a10*a02);
  if (res[1]!=0) res[1][25]=a02;
  a31=(a01*a31);
  a26=(a05*a26);
  a31=(a31-a26);
  a32=(a45*a32);
  a31=(a31+a32);
  a28=(a40*a28);
  a31=(a31-a28);
  a31=(a10*a31);
  if (res[1]!=0) res[1][26]=a31;
  a31=(a09*a40);
  a28=(a04*a45);
  a32=(a31-a28);
  a32=(a32/a11);
  a26=(a41*a32);
  a02=(a09*a45);
  a38=(a04*a40);
  a25=(a02+a38);
  a25=(a25/a11);
  a13=(a37*a25);
  a26=(a26-a13);
  a13=(a19*a32);
  a24=(a30*a25);
  a13=(a13-a24);
  a09=(a09*a01);
  a24=(a00-a09);
  a05=(a04*a05);
  a24=(a24-a05);
  a24=(a24/a11);
  a13=(a13+a24);
  a26=(a26+a13);
  a51=(a29*a25);
  a42=(a17*a32);
  a51=(a51-a42);
  a51=(a22*a51);
  a51=(a51+a13);
  a26=(a26+a51);
  a26=(a35*a26);
  a26=(-a26);
  if (res[1]!=0) res[1][27]=a26;
  a40=(a18*a40);
  a26=(a00-a40);
  a26=(a26-a05);
  a26=(a26/a11);
  a05=(a41*a26);
  a04=(a04*a01);
  a18=(a18*a45);
  a45=(a04-a18);
  a45=(a45/a11);
  a01=(a37*a45);
  a05=(a05-a01);
  a01=(a19*a26);
  a51=(a30*a45);
  a01=(a01-a51);
  a28=(a28+a31);
  a28=(a28/a11);
  a01=(a01+a28);
  a05=(a05+a01);
  a31=(a29*a45);
  a51=(a17*a26);
  a31=(a31-a51);
  a31=(a22*a31);
  a31=(a31+a01);
  a05=(a05+a31);
  a05=(a35*a05);
  a05=(-a05);
  if (res[1]!=0) res[1][28]=a05;
  a18=(a18+a04);
  a18=(a18/a11);
  a04=(a41*a18);
  a00=(a00-a40);
  a00=(a00-a09);
  a00=(a00/a11);
  a09=(a37*a00);
  a04=(a04-a09);
  a09=(a19*a18);
  a40=(a30*a00);
  a09=(a09-a40);
  a38=(a38-a02);
  a38=(a38/a11);
  a09=(a09+a38);
  a04=(a04+a09);
  a11=(a29*a00);
  a02=(a17*a18);
  a11=(a11-a02);
  a11=(a22*a11);
  a11=(a11+a09);
  a04=(a04+a11);
  a04=(a35*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][29]=a04;
  a04=(a21*a25);
  a11=(a41*a24);
  a04=(a04-a11);
  a11=(a49*a25);
  a11=(a11+a32);
  a09=(a19*a24);
  a11=(a11-a09);
  a04=(a04+a11);
  a09=(a17*a24);
  a02=(a48*a25);
  a09=(a09-a02);
  a09=(a22*a09);
  a11=(a11+a09);
  a04=(a04+a11);
  a04=(a35*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][30]=a04;
  a04=(a21*a45);
  a11=(a41*a28);
  a04=(a04-a11);
  a11=(a49*a45);
  a11=(a11+a26);
  a09=(a19*a28);
  a11=(a11-a09);
  a04=(a04+a11);
  a09=(a17*a28);
  a02=(a48*a45);
  a09=(a09-a02);
  a09=(a22*a09);
  a11=(a11+a09);
  a04=(a04+a11);
  a04=(a35*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][31]=a04;
  a04=(a21*a00);
  a41=(a41*a38);
  a04=(a04-a41);
  a41=(a49*a00);
  a41=(a41+a18);
  a19=(a19*a38);
  a41=(a41-a19);
  a04=(a04+a41);
  a17=(a17*a38);
  a19=(a48*a00);
  a17=(a17-a19);
  a17=(a22*a17);
  a41=(a41+a17);
  a04=(a04+a41);
  a04=(a35*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][32]=a04;
  a04=(a37*a24);
  a41=(a21*a32);
  a04=(a04-a41);
  a41=(a49*a32);
  a41=(a25-a41);
  a17=(a30*a24);
  a41=(a41+a17);
  a04=(a04+a41);
  a17=(a48*a32);
  a19=(a29*a24);
  a17=(a17-a19);
  a17=(a22*a17);
  a41=(a41+a17);
  a04=(a04+a41);
  a04=(a35*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][33]=a04;
  a04=(a37*a28);
  a41=(a21*a26);
  a04=(a04-a41);
  a41=(a49*a26);
  a41=(a45-a41);
  a17=(a30*a28);
  a41=(a41+a17);
  a04=(a04+a41);
  a17=(a48*a26);
  a19=(a29*a28);
  a17=(a17-a19);
  a17=(a22*a17);
  a41=(a41+a17);
  a04=(a04+a41);
  a04=(a35*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][34]=a04;
  a37=(a37*a38);
  a21=(a21*a18);
  a37=(a37-a21);
  a49=(a49*a18);
  a49=(a00-a49);
  a30=(a30*a38);
  a49=(a49+a30);
  a37=(a37+a49);
  a48=(a48*a18);
  a29=(a29*a38);
  a48=(a48-a29);
  a48=(a22*a48);
  a49=(a49+a48);
  a37=(a37+a49);
  a35=(a35*a37);
  a35=(-a35);
  if (res[1]!=0) res[1][35]=a35;
  a35=(a43*a25);
  a37=(a39*a32);
  a35=(a35-a37);
  a35=(a22*a35);
  a37=(a23*a25);
  a49=(a34*a32);
  a37=(a37-a49);
  a37=(a10*a37);
  a35=(a35+a37);
  a49=(a06*a25);
  a37=(a37-a49);
  a49=(a33*a32);
  a37=(a37+a49);
  a35=(a35+a37);
  a35=(a03*a35);
  a35=(-a35);
  if (res[1]!=0) res[1][36]=a35;
  a35=(a43*a45);
  a37=(a39*a26);
  a35=(a35-a37);
  a35=(a22*a35);
  a37=(a23*a45);
  a49=(a34*a26);
  a37=(a37-a49);
  a37=(a10*a37);
  a35=(a35+a37);
  a49=(a06*a45);
  a37=(a37-a49);
  a49=(a33*a26);
  a37=(a37+a49);
  a35=(a35+a37);
  a35=(a03*a35);
  a35=(-a35);
  if (res[1]!=0) res[1][37]=a35;
  a35=(a43*a00);
  a37=(a39*a18);
  a35=(a35-a37);
  a35=(a22*a35);
  a37=(a23*a00);
  a49=(a34*a18);
  a37=(a37-a49);
  a37=(a10*a37);
  a35=(a35+a37);
  a49=(a06*a00);
  a37=(a37-a49);
  a49=(a33*a18);
  a37=(a37+a49);
  a35=(a35+a37);
  a35=(a03*a35);
  a35=(-a35);
  if (res[1]!=0) res[1][38]=a35;
  a35=(a39*a24);
  a37=(a15*a25);
  a35=(a35-a37);
  a35=(a22*a35);
  a37=(a34*a24);
  a49=(a08*a25);
  a37=(a37-a49);
  a37=(a10*a37);
  a35=(a35+a37);
  a25=(a44*a25);
  a25=(a25+a37);
  a37=(a33*a24);
  a25=(a25-a37);
  a35=(a35+a25);
  a35=(a03*a35);
  a35=(-a35);
  if (res[1]!=0) res[1][39]=a35;
  a35=(a39*a28);
  a25=(a15*a45);
  a35=(a35-a25);
  a35=(a22*a35);
  a25=(a34*a28);
  a37=(a08*a45);
  a25=(a25-a37);
  a25=(a10*a25);
  a35=(a35+a25);
  a45=(a44*a45);
  a45=(a45+a25);
  a25=(a33*a28);
  a45=(a45-a25);
  a35=(a35+a45);
  a35=(a03*a35);
  a35=(-a35);
  if (res[1]!=0) res[1][40]=a35;
  a39=(a39*a38);
  a35=(a15*a00);
  a39=(a39-a35);
  a39=(a22*a39);
  a34=(a34*a38);
  a35=(a08*a00);
  a34=(a34-a35);
  a34=(a10*a34);
  a39=(a39+a34);
  a00=(a44*a00);
  a00=(a00+a34);
  a33=(a33*a38);
  a00=(a00-a33);
  a39=(a39+a00);
  a39=(a03*a39);
  a39=(-a39);
  if (res[1]!=0) res[1][41]=a39;
  a39=(a15*a32);
  a00=(a43*a24);
  a39=(a39-a00);
  a39=(a22*a39);
  a00=(a08*a32);
  a33=(a23*a24);
  a00=(a00-a33);
  a00=(a10*a00);
  a39=(a39+a00);
  a32=(a44*a32);
  a00=(a00-a32);
  a24=(a06*a24);
  a00=(a00+a24);
  a39=(a39+a00);
  a39=(a03*a39);
  a39=(-a39);
  if (res[1]!=0) res[1][42]=a39;
  a39=(a15*a26);
  a00=(a43*a28);
  a39=(a39-a00);
  a39=(a22*a39);
  a00=(a08*a26);
  a24=(a23*a28);
  a00=(a00-a24);
  a00=(a10*a00);
  a39=(a39+a00);
  a26=(a44*a26);
  a00=(a00-a26);
  a28=(a06*a28);
  a00=(a00+a28);
  a39=(a39+a00);
  a39=(a03*a39);
  a39=(-a39);
  if (res[1]!=0) res[1][43]=a39;
  a15=(a15*a18);
  a43=(a43*a38);
  a15=(a15-a43);
  a22=(a22*a15);
  a08=(a08*a18);
  a23=(a23*a38);
  a08=(a08-a23);
  a10=(a10*a08);
  a22=(a22+a10);
  a44=(a44*a18);
  a10=(a10-a44);
  a06=(a06*a38);
  a10=(a10+a06);
  a22=(a22+a10);
  a03=(a03*a22);
  a03=(-a03);
  if (res[1]!=0) res[1][44]=a03;
  if (res[1]!=0) res[1][45]=a47;
  if (res[1]!=0) res[1][46]=a47;
  if (res[1]!=0) res[1][47]=a47;
  if (res[1]!=0) res[1][48]=a47;
  if (res[1]!=0) res[1][49]=a47;
  if (res[1]!=0) res[1][50]=a47;
  if (res[1]!=0) res[1][51]=a47;
  if (res[1]!=0) res[1][52]=a47;
  if (res[1]!=0) res[1][53]=a47;
  if (res[1]!=0) res[1][54]=a47;
  if (res[1]!=0) res[1][55]=a47;
  if (res[1]!=0) res[1][56]=a47;
  if (res[1]!=0) res[1][57]=a47;
  if (res[1]!=0) res[1][58]=a47;
  if (res[1]!=0) res[1][59]=a47;
  if (res[1]!=0) res[1][60]=a47;
  if (res[1]!=0) res[1][61]=a47;
  if (res[1]!=0) res[1][62]=a47;
  return 0;
}

CASADI_SYMBOL_EXPORT int rover_casadi_imu(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f2(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rover_casadi_imu_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rover_casadi_imu_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rover_casadi_imu_incref(void) {
}

CASADI_SYMBOL_EXPORT void rover_casadi_imu_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rover_casadi_imu_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int rover_casadi_imu_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real rover_casadi_imu_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rover_casadi_imu_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rover_casadi_imu_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rover_casadi_imu_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s6;
    case 2: return casadi_s6;
    case 3: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rover_casadi_imu_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rover_casadi_imu_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int rover_casadi_imu_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


