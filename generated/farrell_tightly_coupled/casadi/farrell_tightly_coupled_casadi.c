/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) farrell_tightly_coupled_casadi_ ## ID
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
#define casadi_s4 CASADI_PREFIX(s4)
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
CASADI_SYMBOL_EXPORT void farrell_tightly_coupled_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {18, 1, 1};
static const casadi_int casadi_s1[3] = {9, 1, 1};
static const casadi_int casadi_s2[3] = {3, 1, 1};
static const casadi_int casadi_s3[3] = {1, 1, 1};
static const casadi_int casadi_s4[3] = {1, 17, 1};

/* farrell_tightly_coupled_casadi_pseudorange:(i0[18],i1[9],i2[3],i3[3],i4)->(o0,o1,o2[1x17]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20;
  a00=arg[0]? arg[0][3] : 0;
  a01=arg[0]? arg[0][0] : 0;
  a02=arg[1]? arg[1][0] : 0;
  a03=(a01*a02);
  a04=arg[0]? arg[0][1] : 0;
  a05=arg[1]? arg[1][1] : 0;
  a06=(a04*a05);
  a03=(a03+a06);
  a06=arg[0]? arg[0][2] : 0;
  a07=arg[1]? arg[1][2] : 0;
  a08=(a06*a07);
  a03=(a03+a08);
  a08=arg[2]? arg[2][0] : 0;
  a03=(a03+a08);
  a09=arg[3]? arg[3][0] : 0;
  a03=(a03-a09);
  a03=casadi_sq(a03);
  a10=arg[1]? arg[1][3] : 0;
  a11=(a01*a10);
  a12=arg[1]? arg[1][4] : 0;
  a13=(a04*a12);
  a11=(a11+a13);
  a13=arg[1]? arg[1][5] : 0;
  a14=(a06*a13);
  a11=(a11+a14);
  a14=arg[2]? arg[2][1] : 0;
  a11=(a11+a14);
  a15=arg[3]? arg[3][1] : 0;
  a11=(a11-a15);
  a11=casadi_sq(a11);
  a03=(a03+a11);
  a11=arg[1]? arg[1][6] : 0;
  a16=(a01*a11);
  a17=arg[1]? arg[1][7] : 0;
  a18=(a04*a17);
  a16=(a16+a18);
  a18=arg[1]? arg[1][8] : 0;
  a19=(a06*a18);
  a16=(a16+a19);
  a19=arg[2]? arg[2][2] : 0;
  a16=(a16+a19);
  a20=arg[3]? arg[3][2] : 0;
  a16=(a16-a20);
  a16=casadi_sq(a16);
  a03=(a03+a16);
  a03=sqrt(a03);
  a00=(a00+a03);
  if (res[0]!=0) res[0][0]=a00;
  a03=arg[4]? arg[4][0] : 0;
  a03=(a03-a00);
  if (res[1]!=0) res[1][0]=a03;
  a03=(a01*a11);
  a00=(a04*a17);
  a03=(a03+a00);
  a00=(a06*a18);
  a03=(a03+a00);
  a03=(a03+a19);
  a03=(a03-a20);
  a20=(a01*a02);
  a19=(a04*a05);
  a20=(a20+a19);
  a19=(a06*a07);
  a20=(a20+a19);
  a20=(a20+a08);
  a20=(a20-a09);
  a09=casadi_sq(a20);
  a01=(a01*a10);
  a04=(a04*a12);
  a01=(a01+a04);
  a06=(a06*a13);
  a01=(a01+a06);
  a01=(a01+a14);
  a01=(a01-a15);
  a15=casadi_sq(a01);
  a09=(a09+a15);
  a15=casadi_sq(a03);
  a09=(a09+a15);
  a09=sqrt(a09);
  a03=(a03/a09);
  a11=(a11*a03);
  a01=(a01/a09);
  a10=(a10*a01);
  a11=(a11+a10);
  a20=(a20/a09);
  a02=(a02*a20);
  a11=(a11+a02);
  if (res[2]!=0) res[2][0]=a11;
  a17=(a17*a03);
  a12=(a12*a01);
  a17=(a17+a12);
  a05=(a05*a20);
  a17=(a17+a05);
  if (res[2]!=0) res[2][1]=a17;
  a18=(a18*a03);
  a13=(a13*a01);
  a18=(a18+a13);
  a07=(a07*a20);
  a18=(a18+a07);
  if (res[2]!=0) res[2][2]=a18;
  a18=1.;
  if (res[2]!=0) res[2][3]=a18;
  a18=0.;
  if (res[2]!=0) res[2][4]=a18;
  if (res[2]!=0) res[2][5]=a18;
  if (res[2]!=0) res[2][6]=a18;
  if (res[2]!=0) res[2][7]=a18;
  if (res[2]!=0) res[2][8]=a18;
  if (res[2]!=0) res[2][9]=a18;
  if (res[2]!=0) res[2][10]=a18;
  if (res[2]!=0) res[2][11]=a18;
  if (res[2]!=0) res[2][12]=a18;
  if (res[2]!=0) res[2][13]=a18;
  if (res[2]!=0) res[2][14]=a18;
  if (res[2]!=0) res[2][15]=a18;
  if (res[2]!=0) res[2][16]=a18;
  return 0;
}

CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_pseudorange(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_pseudorange_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void farrell_tightly_coupled_casadi_pseudorange_release(int mem) {
}

CASADI_SYMBOL_EXPORT void farrell_tightly_coupled_casadi_pseudorange_incref(void) {
}

CASADI_SYMBOL_EXPORT void farrell_tightly_coupled_casadi_pseudorange_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int farrell_tightly_coupled_casadi_pseudorange_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int farrell_tightly_coupled_casadi_pseudorange_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real farrell_tightly_coupled_casadi_pseudorange_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* farrell_tightly_coupled_casadi_pseudorange_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    case 4: return "i4";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* farrell_tightly_coupled_casadi_pseudorange_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* farrell_tightly_coupled_casadi_pseudorange_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s2;
    case 4: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* farrell_tightly_coupled_casadi_pseudorange_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    case 1: return casadi_s3;
    case 2: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_pseudorange_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_pseudorange_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* farrell_tightly_coupled_casadi_pseudorange_lever_arm:(i0[18],i1[9],i2[3],i3[3],i4[3])->(o0,o1[1x17]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37;
  a00=arg[0]? arg[0][3] : 0;
  a01=arg[0]? arg[0][0] : 0;
  a02=1.;
  a03=arg[0]? arg[0][10] : 0;
  a04=(2.*a03);
  a05=(a04*a03);
  a06=(a02-a05);
  a07=arg[0]? arg[0][11] : 0;
  a08=(2.*a07);
  a09=(a08*a07);
  a06=(a06-a09);
  a10=arg[3]? arg[3][0] : 0;
  a06=(a06*a10);
  a11=arg[0]? arg[0][9] : 0;
  a12=(a04*a11);
  a13=arg[0]? arg[0][8] : 0;
  a14=(a08*a13);
  a15=(a12-a14);
  a16=arg[3]? arg[3][1] : 0;
  a15=(a15*a16);
  a06=(a06+a15);
  a04=(a04*a13);
  a15=(a08*a11);
  a17=(a04+a15);
  a18=arg[3]? arg[3][2] : 0;
  a17=(a17*a18);
  a06=(a06+a17);
  a06=(a01+a06);
  a17=arg[1]? arg[1][0] : 0;
  a19=(a06*a17);
  a20=arg[0]? arg[0][1] : 0;
  a14=(a14+a12);
  a14=(a14*a10);
  a12=(2.*a11);
  a21=(a12*a11);
  a22=(a02-a21);
  a22=(a22-a09);
  a22=(a22*a16);
  a14=(a14+a22);
  a08=(a08*a03);
  a12=(a12*a13);
  a22=(a08-a12);
  a22=(a22*a18);
  a14=(a14+a22);
  a14=(a20+a14);
  a22=arg[1]? arg[1][1] : 0;
  a09=(a14*a22);
  a19=(a19+a09);
  a09=arg[0]? arg[0][2] : 0;
  a15=(a15-a04);
  a15=(a15*a10);
  a12=(a12+a08);
  a12=(a12*a16);
  a15=(a15+a12);
  a21=(a02-a21);
  a21=(a21-a05);
  a21=(a21*a18);
  a15=(a15+a21);
  a15=(a09+a15);
  a21=arg[1]? arg[1][2] : 0;
  a05=(a15*a21);
  a19=(a19+a05);
  a05=arg[2]? arg[2][0] : 0;
  a19=(a19+a05);
  a12=arg[4]? arg[4][0] : 0;
  a19=(a19-a12);
  a19=casadi_sq(a19);
  a08=arg[1]? arg[1][3] : 0;
  a04=(a06*a08);
  a23=arg[1]? arg[1][4] : 0;
  a24=(a14*a23);
  a04=(a04+a24);
  a24=arg[1]? arg[1][5] : 0;
  a25=(a15*a24);
  a04=(a04+a25);
  a25=arg[2]? arg[2][1] : 0;
  a04=(a04+a25);
  a26=arg[4]? arg[4][1] : 0;
  a04=(a04-a26);
  a04=casadi_sq(a04);
  a19=(a19+a04);
  a04=arg[1]? arg[1][6] : 0;
  a06=(a06*a04);
  a27=arg[1]? arg[1][7] : 0;
  a14=(a14*a27);
  a06=(a06+a14);
  a14=arg[1]? arg[1][8] : 0;
  a15=(a15*a14);
  a06=(a06+a15);
  a15=arg[2]? arg[2][2] : 0;
  a06=(a06+a15);
  a28=arg[4]? arg[4][2] : 0;
  a06=(a06-a28);
  a06=casadi_sq(a06);
  a19=(a19+a06);
  a19=sqrt(a19);
  a00=(a00+a19);
  if (res[0]!=0) res[0][0]=a00;
  a00=(2.*a03);
  a19=(a00*a03);
  a06=(a02-a19);
  a29=(2.*a07);
  a30=(a29*a07);
  a06=(a06-a30);
  a06=(a06*a10);
  a31=(a00*a11);
  a32=(a29*a13);
  a33=(a31-a32);
  a33=(a33*a16);
  a06=(a06+a33);
  a33=(a00*a13);
  a34=(a29*a11);
  a35=(a33+a34);
  a35=(a35*a18);
  a06=(a06+a35);
  a01=(a01+a06);
  a06=(a01*a04);
  a32=(a32+a31);
  a32=(a32*a10);
  a31=(2.*a11);
  a35=(a31*a11);
  a36=(a02-a35);
  a36=(a36-a30);
  a36=(a36*a16);
  a32=(a32+a36);
  a36=(a29*a03);
  a30=(a31*a13);
  a37=(a36-a30);
  a37=(a37*a18);
  a32=(a32+a37);
  a20=(a20+a32);
  a32=(a20*a27);
  a06=(a06+a32);
  a34=(a34-a33);
  a34=(a34*a10);
  a30=(a30+a36);
  a30=(a30*a16);
  a34=(a34+a30);
  a35=(a02-a35);
  a35=(a35-a19);
  a35=(a35*a18);
  a34=(a34+a35);
  a09=(a09+a34);
  a34=(a09*a14);
  a06=(a06+a34);
  a06=(a06+a15);
  a06=(a06-a28);
  a28=(a01*a17);
  a15=(a20*a22);
  a28=(a28+a15);
  a15=(a09*a21);
  a28=(a28+a15);
  a28=(a28+a05);
  a28=(a28-a12);
  a12=casadi_sq(a28);
  a01=(a01*a08);
  a20=(a20*a23);
  a01=(a01+a20);
  a09=(a09*a24);
  a01=(a01+a09);
  a01=(a01+a25);
  a01=(a01-a26);
  a26=casadi_sq(a01);
  a12=(a12+a26);
  a26=casadi_sq(a06);
  a12=(a12+a26);
  a12=sqrt(a12);
  a06=(a06/a12);
  a04=(a04*a06);
  a01=(a01/a12);
  a08=(a08*a01);
  a04=(a04+a08);
  a28=(a28/a12);
  a17=(a17*a28);
  a04=(a04+a17);
  if (res[1]!=0) res[1][0]=a04;
  a27=(a27*a06);
  a23=(a23*a01);
  a27=(a27+a23);
  a22=(a22*a28);
  a27=(a27+a22);
  if (res[1]!=0) res[1][1]=a27;
  a14=(a14*a06);
  a24=(a24*a01);
  a14=(a14+a24);
  a21=(a21*a28);
  a14=(a14+a21);
  if (res[1]!=0) res[1][2]=a14;
  if (res[1]!=0) res[1][3]=a02;
  a02=0.;
  if (res[1]!=0) res[1][4]=a02;
  if (res[1]!=0) res[1][5]=a02;
  if (res[1]!=0) res[1][6]=a02;
  if (res[1]!=0) res[1][7]=a02;
  a21=5.0000000000000000e-01;
  a28=(a16*a14);
  a24=(a18*a27);
  a01=(a28-a24);
  a06=(a13*a01);
  a22=(a18*a14);
  a23=(a16*a27);
  a17=(a22+a23);
  a12=(a11*a17);
  a06=(a06-a12);
  a06=(2.*a06);
  a17=(a31*a17);
  a06=(a06-a17);
  a14=(a10*a14);
  a18=(a18*a04);
  a17=(a14+a18);
  a12=(a29*a17);
  a06=(a06+a12);
  a27=(a10*a27);
  a16=(a16*a04);
  a12=(a27+a16);
  a08=(a00*a12);
  a06=(a06+a08);
  a08=(a13*a06);
  a31=(a31*a01);
  a18=(a18-a14);
  a14=(a00*a18);
  a31=(a31+a14);
  a27=(a27-a16);
  a16=(a29*a27);
  a31=(a31+a16);
  a16=(a11*a31);
  a08=(a08-a16);
  a28=(a28+a24);
  a24=(a03*a28);
  a17=(a11*a17);
  a24=(a24+a17);
  a27=(a13*a27);
  a24=(a24+a27);
  a10=(a10*a04);
  a23=(a23+a10);
  a04=(a07*a23);
  a24=(a24-a04);
  a24=(2.*a24);
  a23=(a29*a23);
  a24=(a24-a23);
  a23=(a03*a24);
  a08=(a08+a23);
  a29=(a29*a28);
  a22=(a22+a10);
  a00=(a00*a22);
  a29=(a29-a00);
  a18=(a13*a18);
  a12=(a11*a12);
  a18=(a18+a12);
  a22=(a03*a22);
  a18=(a18-a22);
  a18=(2.*a18);
  a29=(a29+a18);
  a18=(a07*a29);
  a08=(a08-a18);
  a08=(a21*a08);
  if (res[1]!=0) res[1][8]=a08;
  a08=(a07*a06);
  a18=(a03*a31);
  a08=(a08-a18);
  a18=(a11*a24);
  a08=(a08-a18);
  a18=(a13*a29);
  a08=(a08+a18);
  a08=(a21*a08);
  if (res[1]!=0) res[1][9]=a08;
  a13=(a13*a24);
  a07=(a07*a31);
  a03=(a03*a06);
  a07=(a07+a03);
  a13=(a13-a07);
  a11=(a11*a29);
  a13=(a13+a11);
  a21=(a21*a13);
  if (res[1]!=0) res[1][10]=a21;
  if (res[1]!=0) res[1][11]=a02;
  if (res[1]!=0) res[1][12]=a02;
  if (res[1]!=0) res[1][13]=a02;
  if (res[1]!=0) res[1][14]=a02;
  if (res[1]!=0) res[1][15]=a02;
  if (res[1]!=0) res[1][16]=a02;
  return 0;
}

CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_pseudorange_lever_arm(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_pseudorange_lever_arm_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void farrell_tightly_coupled_casadi_pseudorange_lever_arm_release(int mem) {
}

CASADI_SYMBOL_EXPORT void farrell_tightly_coupled_casadi_pseudorange_lever_arm_incref(void) {
}

CASADI_SYMBOL_EXPORT void farrell_tightly_coupled_casadi_pseudorange_lever_arm_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int farrell_tightly_coupled_casadi_pseudorange_lever_arm_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int farrell_tightly_coupled_casadi_pseudorange_lever_arm_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real farrell_tightly_coupled_casadi_pseudorange_lever_arm_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* farrell_tightly_coupled_casadi_pseudorange_lever_arm_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    case 4: return "i4";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* farrell_tightly_coupled_casadi_pseudorange_lever_arm_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* farrell_tightly_coupled_casadi_pseudorange_lever_arm_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s2;
    case 4: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* farrell_tightly_coupled_casadi_pseudorange_lever_arm_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_pseudorange_lever_arm_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int farrell_tightly_coupled_casadi_pseudorange_lever_arm_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


