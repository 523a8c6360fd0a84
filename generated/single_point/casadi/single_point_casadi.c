/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) single_point_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void single_point_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int single_point_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int single_point_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {1, 4, 1};

/* single_point_casadi_pseudorange:(i0[4],i1[3],i2,i3,i4)->(o0,o1[1x4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10;
  a00=arg[0]? arg[0][3] : 0;
  a01=arg[4]? arg[4][0] : 0;
  a00=(a00+a01);
  a01=arg[0]? arg[0][0] : 0;
  a02=arg[1]? arg[1][0] : 0;
  a03=(a01-a02);
  a03=casadi_sq(a03);
  a04=arg[0]? arg[0][1] : 0;
  a05=arg[1]? arg[1][1] : 0;
  a06=(a04-a05);
  a06=casadi_sq(a06);
  a03=(a03+a06);
  a06=arg[0]? arg[0][2] : 0;
  a07=arg[1]? arg[1][2] : 0;
  a08=(a06-a07);
  a08=casadi_sq(a08);
  a03=(a03+a08);
  a03=sqrt(a03);
  a08=arg[3]? arg[3][0] : 0;
  a09=299792458.;
  a10=arg[2]? arg[2][0] : 0;
  a09=(a09*a10);
  a08=(a08-a09);
  a03=(a03+a08);
  a08=2.4323877909897254e-13;
  a09=(a08*a02);
  a09=(a04*a09);
  a10=(a08*a05);
  a10=(a01*a10);
  a09=(a09-a10);
  a03=(a03+a09);
  a00=(a00+a03);
  if (res[0]!=0) res[0][0]=a00;
  a01=(a01-a02);
  a00=casadi_sq(a01);
  a04=(a04-a05);
  a03=casadi_sq(a04);
  a00=(a00+a03);
  a06=(a06-a07);
  a07=casadi_sq(a06);
  a00=(a00+a07);
  a00=sqrt(a00);
  a01=(a01/a00);
  a05=(a08*a05);
  a01=(a01-a05);
  if (res[1]!=0) res[1][0]=a01;
  a08=(a08*a02);
  a04=(a04/a00);
  a08=(a08+a04);
  if (res[1]!=0) res[1][1]=a08;
  a06=(a06/a00);
  if (res[1]!=0) res[1][2]=a06;
  a06=1.;
  if (res[1]!=0) res[1][3]=a06;
  return 0;
}

CASADI_SYMBOL_EXPORT int single_point_casadi_pseudorange(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int single_point_casadi_pseudorange_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void single_point_casadi_pseudorange_release(int mem) {
}

CASADI_SYMBOL_EXPORT void single_point_casadi_pseudorange_incref(void) {
}

CASADI_SYMBOL_EXPORT void single_point_casadi_pseudorange_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int single_point_casadi_pseudorange_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int single_point_casadi_pseudorange_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real single_point_casadi_pseudorange_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* single_point_casadi_pseudorange_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    case 4: return "i4";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* single_point_casadi_pseudorange_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* single_point_casadi_pseudorange_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s2;
    case 4: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* single_point_casadi_pseudorange_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    case 1: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int single_point_casadi_pseudorange_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int single_point_casadi_pseudorange_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* single_point_casadi_pseudorange_without_sagnac:(i0[4],i1[3],i2,i3,i4)->(o0,o1[1x4]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10;
  a00=arg[0]? arg[0][3] : 0;
  a01=arg[4]? arg[4][0] : 0;
  a00=(a00+a01);
  a01=arg[0]? arg[0][0] : 0;
  a02=arg[1]? arg[1][0] : 0;
  a03=(a01-a02);
  a03=casadi_sq(a03);
  a04=arg[0]? arg[0][1] : 0;
  a05=arg[1]? arg[1][1] : 0;
  a06=(a04-a05);
  a06=casadi_sq(a06);
  a03=(a03+a06);
  a06=arg[0]? arg[0][2] : 0;
  a07=arg[1]? arg[1][2] : 0;
  a08=(a06-a07);
  a08=casadi_sq(a08);
  a03=(a03+a08);
  a03=sqrt(a03);
  a08=arg[3]? arg[3][0] : 0;
  a09=299792458.;
  a10=arg[2]? arg[2][0] : 0;
  a09=(a09*a10);
  a08=(a08-a09);
  a03=(a03+a08);
  a00=(a00+a03);
  if (res[0]!=0) res[0][0]=a00;
  a01=(a01-a02);
  a02=casadi_sq(a01);
  a04=(a04-a05);
  a05=casadi_sq(a04);
  a02=(a02+a05);
  a06=(a06-a07);
  a07=casadi_sq(a06);
  a02=(a02+a07);
  a02=sqrt(a02);
  a01=(a01/a02);
  if (res[1]!=0) res[1][0]=a01;
  a04=(a04/a02);
  if (res[1]!=0) res[1][1]=a04;
  a06=(a06/a02);
  if (res[1]!=0) res[1][2]=a06;
  a06=1.;
  if (res[1]!=0) res[1][3]=a06;
  return 0;
}

CASADI_SYMBOL_EXPORT int single_point_casadi_pseudorange_without_sagnac(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int single_point_casadi_pseudorange_without_sagnac_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void single_point_casadi_pseudorange_without_sagnac_release(int mem) {
}

CASADI_SYMBOL_EXPORT void single_point_casadi_pseudorange_without_sagnac_incref(void) {
}

CASADI_SYMBOL_EXPORT void single_point_casadi_pseudorange_without_sagnac_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int single_point_casadi_pseudorange_without_sagnac_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int single_point_casadi_pseudorange_without_sagnac_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real single_point_casadi_pseudorange_without_sagnac_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* single_point_casadi_pseudorange_without_sagnac_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    case 4: return "i4";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* single_point_casadi_pseudorange_without_sagnac_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* single_point_casadi_pseudorange_without_sagnac_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s2;
    case 4: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* single_point_casadi_pseudorange_without_sagnac_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    case 1: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int single_point_casadi_pseudorange_without_sagnac_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int single_point_casadi_pseudorange_without_sagnac_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* single_point_casadi_broadcast_orbit:(i0,i1,i2,i3,i4,i5,i6,i7,i8,i9,i10,i11,i12,i13,i14,i15,i16,i17,i18,i19,i20,i21)->(o0[3],o1,o2[3],o3) */
static int casadi_f2(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53;
  a00=arg[10]? arg[10][0] : 0;
  a01=7.2921151466999996e-05;
  a02=(a00-a01);
  a03=arg[0]? arg[0][0] : 0;
  a04=arg[1]? arg[1][0] : 0;
  a05=(a03-a04);
  a06=604800.;
  a07=5.0000000000000000e-01;
  a08=1.6534391534391535e-06;
  a09=(a08*a05);
  a09=(a07+a09);
  a09=floor(a09);
  a09=(a06*a09);
  a05=(a05-a09);
  a02=(a02*a05);
  a09=arg[9]? arg[9][0] : 0;
  a02=(a02+a09);
  a10=(a01*a04);
  a02=(a02-a10);
  a10=cos(a02);
  a11=arg[11]? arg[11][0] : 0;
  a12=arg[5]? arg[5][0] : 0;
  a13=1.9964981843217388e+07;
  a14=arg[3]? arg[3][0] : 0;
  a15=casadi_sq(a14);
  a16=casadi_sq(a15);
  a16=(a16*a15);
  a16=(1./a16);
  a16=sqrt(a16);
  a16=(a13*a16);
  a17=arg[6]? arg[6][0] : 0;
  a16=(a16+a17);
  a16=(a16*a05);
  a16=(a12+a16);
  a18=arg[4]? arg[4][0] : 0;
  a19=sin(a16);
  a19=(a18*a19);
  a19=(a16+a19);
  a20=sin(a19);
  a20=(a18*a20);
  a20=(a19-a20);
  a20=(a20-a16);
  a21=1.;
  a22=cos(a19);
  a22=(a18*a22);
  a22=(a21-a22);
  a20=(a20/a22);
  a19=(a19-a20);
  a20=sin(a19);
  a20=(a18*a20);
  a20=(a19-a20);
  a20=(a20-a16);
  a22=cos(a19);
  a22=(a18*a22);
  a22=(a21-a22);
  a20=(a20/a22);
  a19=(a19-a20);
  a20=sin(a19);
  a20=(a18*a20);
  a20=(a19-a20);
  a20=(a20-a16);
  a22=cos(a19);
  a22=(a18*a22);
  a22=(a21-a22);
  a20=(a20/a22);
  a19=(a19-a20);
  a20=sin(a19);
  a20=(a18*a20);
  a20=(a19-a20);
  a20=(a20-a16);
  a16=cos(a19);
  a16=(a18*a16);
  a16=(a21-a16);
  a20=(a20/a16);
  a19=(a19-a20);
  a20=casadi_sq(a18);
  a20=(a21-a20);
  a20=sqrt(a20);
  a20=(a21+a20);
  a20=(a18/a20);
  a16=sin(a19);
  a16=(a20*a16);
  a22=cos(a19);
  a20=(a22*a20);
  a20=(a21-a20);
  a16=atan2(a16,a20);
  a16=(2.*a16);
  a16=(a19+a16);
  a16=(a11+a16);
  a20=(2.*a16);
  a23=cos(a20);
  a24=arg[12]? arg[12][0] : 0;
  a25=(a23*a24);
  a26=arg[13]? arg[13][0] : 0;
  a20=sin(a20);
  a27=(a26*a20);
  a25=(a25+a27);
  a25=(a25+a16);
  a16=cos(a25);
  a27=arg[14]? arg[14][0] : 0;
  a28=(a23*a27);
  a29=arg[15]? arg[15][0] : 0;
  a30=(a29*a20);
  a28=(a28+a30);
  a22=(a22*a18);
  a22=(a21-a22);
  a15=(a15*a22);
  a28=(a28+a15);
  a16=(a16*a28);
  a15=(a10*a16);
  a22=arg[7]? arg[7][0] : 0;
  a30=arg[16]? arg[16][0] : 0;
  a23=(a30*a23);
  a23=(a22+a23);
  a31=arg[17]? arg[17][0] : 0;
  a20=(a31*a20);
  a32=arg[8]? arg[8][0] : 0;
  a05=(a32*a05);
  a20=(a20+a05);
  a23=(a23+a20);
  a20=cos(a23);
  a25=sin(a25);
  a28=(a28*a25);
  a20=(a20*a28);
  a02=sin(a02);
  a25=(a20*a02);
  a15=(a15-a25);
  if (res[0]!=0) res[0][0]=a15;
  a10=(a10*a20);
  a16=(a16*a02);
  a10=(a10+a16);
  if (res[0]!=0) res[0][1]=a10;
  a23=sin(a23);
  a28=(a28*a23);
  if (res[0]!=0) res[0][2]=a28;
  a28=arg[18]? arg[18][0] : 0;
  a23=-4.4428076330000000e-10;
  a10=(a18*a14);
  a10=(a23*a10);
  a19=sin(a19);
  a10=(a10*a19);
  a28=(a28+a10);
  a10=arg[19]? arg[19][0] : 0;
  a19=arg[20]? arg[20][0] : 0;
  a16=arg[2]? arg[2][0] : 0;
  a02=(a03-a16);
  a20=(a08*a02);
  a20=(a07+a20);
  a20=floor(a20);
  a20=(a06*a20);
  a02=(a02-a20);
  a20=(a19*a02);
  a20=(a10+a20);
  a20=(a20*a02);
  a02=arg[21]? arg[21][0] : 0;
  a20=(a20-a02);
  a28=(a28+a20);
  if (res[1]!=0) res[1][0]=a28;
  a00=(a00-a01);
  a28=(a03-a04);
  a20=(a08*a28);
  a20=(a07+a20);
  a20=floor(a20);
  a20=(a06*a20);
  a28=(a28-a20);
  a20=(a00*a28);
  a20=(a20+a09);
  a01=(a01*a04);
  a20=(a20-a01);
  a01=cos(a20);
  a09=casadi_sq(a14);
  a02=casadi_sq(a09);
  a02=(a02*a09);
  a02=(1./a02);
  a02=sqrt(a02);
  a02=(a13*a02);
  a02=(a02+a17);
  a15=(a02*a28);
  a15=(a12+a15);
  a25=sin(a15);
  a25=(a18*a25);
  a25=(a15+a25);
  a05=sin(a25);
  a05=(a18*a05);
  a05=(a25-a05);
  a05=(a05-a15);
  a33=cos(a25);
  a33=(a18*a33);
  a33=(a21-a33);
  a05=(a05/a33);
  a34=(a25-a05);
  a35=sin(a34);
  a35=(a18*a35);
  a35=(a34-a35);
  a35=(a35-a15);
  a36=cos(a34);
  a36=(a18*a36);
  a36=(a21-a36);
  a35=(a35/a36);
  a37=(a34-a35);
  a38=sin(a37);
  a38=(a18*a38);
  a38=(a37-a38);
  a38=(a38-a15);
  a39=cos(a37);
  a39=(a18*a39);
  a39=(a21-a39);
  a38=(a38/a39);
  a40=(a37-a38);
  a41=sin(a40);
  a41=(a18*a41);
  a41=(a40-a41);
  a41=(a41-a15);
  a42=cos(a40);
  a42=(a18*a42);
  a42=(a21-a42);
  a41=(a41/a42);
  a43=(a40-a41);
  a44=casadi_sq(a18);
  a44=(a21-a44);
  a44=sqrt(a44);
  a44=(a21+a44);
  a44=(a18/a44);
  a45=sin(a43);
  a45=(a44*a45);
  a46=cos(a43);
  a47=(a46*a44);
  a47=(a21-a47);
  a48=atan2(a45,a47);
  a48=(2.*a48);
  a48=(a43+a48);
  a11=(a11+a48);
  a48=(2.*a11);
  a49=cos(a48);
  a50=(a49*a24);
  a51=sin(a48);
  a52=(a26*a51);
  a50=(a50+a52);
  a50=(a50+a11);
  a11=cos(a50);
  a52=cos(a48);
  a15=cos(a15);
  a15=(a15*a02);
  a15=(a18*a15);
  a15=(a02+a15);
  a53=cos(a25);
  a53=(a53*a15);
  a53=(a18*a53);
  a53=(a15-a53);
  a53=(a53-a02);
  a53=(a53/a33);
  a05=(a05/a33);
  a25=sin(a25);
  a25=(a25*a15);
  a25=(a18*a25);
  a05=(a05*a25);
  a53=(a53-a05);
  a15=(a15-a53);
  a53=cos(a34);
  a53=(a53*a15);
  a53=(a18*a53);
  a53=(a15-a53);
  a53=(a53-a02);
  a53=(a53/a36);
  a35=(a35/a36);
  a34=sin(a34);
  a34=(a34*a15);
  a34=(a18*a34);
  a35=(a35*a34);
  a53=(a53-a35);
  a15=(a15-a53);
  a53=cos(a37);
  a53=(a53*a15);
  a53=(a18*a53);
  a53=(a15-a53);
  a53=(a53-a02);
  a53=(a53/a39);
  a38=(a38/a39);
  a37=sin(a37);
  a37=(a37*a15);
  a37=(a18*a37);
  a38=(a38*a37);
  a53=(a53-a38);
  a15=(a15-a53);
  a53=cos(a40);
  a53=(a53*a15);
  a53=(a18*a53);
  a53=(a15-a53);
  a53=(a53-a02);
  a53=(a53/a42);
  a41=(a41/a42);
  a40=sin(a40);
  a40=(a40*a15);
  a40=(a18*a40);
  a41=(a41*a40);
  a53=(a53-a41);
  a15=(a15-a53);
  a53=casadi_sq(a45);
  a41=casadi_sq(a47);
  a53=(a53+a41);
  a47=(a47/a53);
  a41=cos(a43);
  a41=(a41*a15);
  a41=(a44*a41);
  a47=(a47*a41);
  a45=(a45/a53);
  a43=sin(a43);
  a43=(a43*a15);
  a44=(a44*a43);
  a45=(a45*a44);
  a47=(a47-a45);
  a47=(2.*a47);
  a15=(a15+a47);
  a47=(2.*a15);
  a52=(a52*a47);
  a45=(a29*a52);
  a48=sin(a48);
  a48=(a48*a47);
  a47=(a27*a48);
  a45=(a45-a47);
  a43=(a18*a43);
  a43=(a09*a43);
  a45=(a45+a43);
  a43=(a11*a45);
  a27=(a49*a27);
  a29=(a29*a51);
  a27=(a27+a29);
  a46=(a46*a18);
  a46=(a21-a46);
  a09=(a09*a46);
  a27=(a27+a09);
  a09=sin(a50);
  a26=(a26*a52);
  a24=(a24*a48);
  a26=(a26-a24);
  a26=(a26+a15);
  a09=(a09*a26);
  a09=(a27*a09);
  a43=(a43-a09);
  a09=(a01*a43);
  a11=(a11*a27);
  a15=sin(a20);
  a15=(a15*a00);
  a24=(a11*a15);
  a09=(a09-a24);
  a24=sin(a20);
  a49=(a30*a49);
  a22=(a22+a49);
  a51=(a31*a51);
  a28=(a32*a28);
  a51=(a51+a28);
  a22=(a22+a51);
  a51=cos(a22);
  a28=sin(a50);
  a45=(a28*a45);
  a50=cos(a50);
  a50=(a50*a26);
  a50=(a27*a50);
  a45=(a45+a50);
  a50=(a51*a45);
  a27=(a27*a28);
  a28=sin(a22);
  a31=(a31*a52);
  a31=(a31+a32);
  a30=(a30*a48);
  a31=(a31-a30);
  a28=(a28*a31);
  a28=(a27*a28);
  a50=(a50-a28);
  a28=(a24*a50);
  a51=(a51*a27);
  a20=cos(a20);
  a20=(a20*a00);
  a00=(a51*a20);
  a28=(a28+a00);
  a09=(a09-a28);
  if (res[2]!=0) res[2][0]=a09;
  a01=(a01*a50);
  a51=(a51*a15);
  a01=(a01-a51);
  a24=(a24*a43);
  a11=(a11*a20);
  a24=(a24+a11);
  a01=(a01+a24);
  if (res[2]!=0) res[2][1]=a01;
  a01=sin(a22);
  a01=(a01*a45);
  a22=cos(a22);
  a22=(a22*a31);
  a27=(a27*a22);
  a01=(a01+a27);
  if (res[2]!=0) res[2][2]=a01;
  a01=(a18*a14);
  a23=(a23*a01);
  a14=casadi_sq(a14);
  a01=casadi_sq(a14);
  a01=(a01*a14);
  a01=(1./a01);
  a01=sqrt(a01);
  a13=(a13*a01);
  a13=(a13+a17);
  a04=(a03-a04);
  a17=(a08*a04);
  a17=(a07+a17);
  a17=floor(a17);
  a17=(a06*a17);
  a04=(a04-a17);
  a04=(a13*a04);
  a12=(a12+a04);
  a04=sin(a12);
  a04=(a18*a04);
  a04=(a12+a04);
  a17=sin(a04);
  a17=(a18*a17);
  a17=(a04-a17);
  a17=(a17-a12);
  a01=cos(a04);
  a01=(a18*a01);
  a01=(a21-a01);
  a17=(a17/a01);
  a14=(a04-a17);
  a27=sin(a14);
  a27=(a18*a27);
  a27=(a14-a27);
  a27=(a27-a12);
  a22=cos(a14);
  a22=(a18*a22);
  a22=(a21-a22);
  a27=(a27/a22);
  a31=(a14-a27);
  a45=sin(a31);
  a45=(a18*a45);
  a45=(a31-a45);
  a45=(a45-a12);
  a24=cos(a31);
  a24=(a18*a24);
  a24=(a21-a24);
  a45=(a45/a24);
  a11=(a31-a45);
  a20=sin(a11);
  a20=(a18*a20);
  a20=(a11-a20);
  a20=(a20-a12);
  a43=cos(a11);
  a43=(a18*a43);
  a21=(a21-a43);
  a20=(a20/a21);
  a43=(a11-a20);
  a43=cos(a43);
  a12=cos(a12);
  a12=(a12*a13);
  a12=(a18*a12);
  a12=(a13+a12);
  a51=cos(a04);
  a51=(a51*a12);
  a51=(a18*a51);
  a51=(a12-a51);
  a51=(a51-a13);
  a51=(a51/a01);
  a17=(a17/a01);
  a04=sin(a04);
  a04=(a04*a12);
  a04=(a18*a04);
  a17=(a17*a04);
  a51=(a51-a17);
  a12=(a12-a51);
  a51=cos(a14);
  a51=(a51*a12);
  a51=(a18*a51);
  a51=(a12-a51);
  a51=(a51-a13);
  a51=(a51/a22);
  a27=(a27/a22);
  a14=sin(a14);
  a14=(a14*a12);
  a14=(a18*a14);
  a27=(a27*a14);
  a51=(a51-a27);
  a12=(a12-a51);
  a51=cos(a31);
  a51=(a51*a12);
  a51=(a18*a51);
  a51=(a12-a51);
  a51=(a51-a13);
  a51=(a51/a24);
  a45=(a45/a24);
  a31=sin(a31);
  a31=(a31*a12);
  a31=(a18*a31);
  a45=(a45*a31);
  a51=(a51-a45);
  a12=(a12-a51);
  a51=cos(a11);
  a51=(a51*a12);
  a51=(a18*a51);
  a51=(a12-a51);
  a51=(a51-a13);
  a51=(a51/a21);
  a20=(a20/a21);
  a11=sin(a11);
  a11=(a11*a12);
  a18=(a18*a11);
  a20=(a20*a18);
  a51=(a51-a20);
  a12=(a12-a51);
  a43=(a43*a12);
  a23=(a23*a43);
  a03=(a03-a16);
  a08=(a08*a03);
  a07=(a07+a08);
  a07=floor(a07);
  a06=(a06*a07);
  a03=(a03-a06);
  a06=(a03*a19);
  a19=(a19*a03);
  a10=(a10+a19);
  a06=(a06+a10);
  a23=(a23+a06);
  if (res[3]!=0) res[3][0]=a23;
  return 0;
}

CASADI_SYMBOL_EXPORT int single_point_casadi_broadcast_orbit(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f2(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int single_point_casadi_broadcast_orbit_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void single_point_casadi_broadcast_orbit_release(int mem) {
}

CASADI_SYMBOL_EXPORT void single_point_casadi_broadcast_orbit_incref(void) {
}

CASADI_SYMBOL_EXPORT void single_point_casadi_broadcast_orbit_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int single_point_casadi_broadcast_orbit_n_in(void) { return 22;}

CASADI_SYMBOL_EXPORT casadi_int single_point_casadi_broadcast_orbit_n_out(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_real single_point_casadi_broadcast_orbit_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* single_point_casadi_broadcast_orbit_name_in(casadi_int i) {
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
    case 9: return "i9";
    case 10: return "i10";
    case 11: return "i11";
    case 12: return "i12";
    case 13: return "i13";
    case 14: return "i14";
    case 15: return "i15";
    case 16: return "i16";
    case 17: return "i17";
    case 18: return "i18";
    case 19: return "i19";
    case 20: return "i20";
    case 21: return "i21";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* single_point_casadi_broadcast_orbit_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    case 3: return "o3";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* single_point_casadi_broadcast_orbit_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    case 1: return casadi_s2;
    case 2: return casadi_s2;
    case 3: return casadi_s2;
    case 4: return casadi_s2;
    case 5: return casadi_s2;
    case 6: return casadi_s2;
    case 7: return casadi_s2;
    case 8: return casadi_s2;
    case 9: return casadi_s2;
    case 10: return casadi_s2;
    case 11: return casadi_s2;
    case 12: return casadi_s2;
    case 13: return casadi_s2;
    case 14: return casadi_s2;
    case 15: return casadi_s2;
    case 16: return casadi_s2;
    case 17: return casadi_s2;
    case 18: return casadi_s2;
    case 19: return casadi_s2;
    case 20: return casadi_s2;
    case 21: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* single_point_casadi_broadcast_orbit_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s2;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int single_point_casadi_broadcast_orbit_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 4;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int single_point_casadi_broadcast_orbit_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 4*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


