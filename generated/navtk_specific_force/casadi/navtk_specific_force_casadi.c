/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) navtk_specific_force_casadi_ ## ID
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
#define casadi_s5 CASADI_PREFIX(s5)

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
CASADI_SYMBOL_EXPORT void navtk_specific_force_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {9, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {3, 3, 1};
static const casadi_int casadi_s4[3] = {16, 1, 1};
static const casadi_int casadi_s5[3] = {3, 15, 1};

/* navtk_specific_force_casadi_calc_force:(i0[9],i1[3],i2[3],i3)->(o0[3],o1[3x3],o2[3x3],o3[3x3],o4[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  a00=arg[2]? arg[2][2] : 0;
  a01=5.0000000000000000e-01;
  a02=arg[1]? arg[1][1] : 0;
  a03=(a01*a02);
  a04=(a00*a03);
  a05=arg[2]? arg[2][0] : 0;
  a04=(a04+a05);
  a06=arg[2]? arg[2][1] : 0;
  a07=arg[1]? arg[1][2] : 0;
  a08=(a01*a07);
  a09=(a06*a08);
  a04=(a04-a09);
  a09=arg[3]? arg[3][0] : 0;
  a04=(a04/a09);
  a10=arg[0]? arg[0][0] : 0;
  a11=(a04*a10);
  a08=(a05*a08);
  a08=(a08+a06);
  a12=arg[1]? arg[1][0] : 0;
  a13=(a01*a12);
  a14=(a00*a13);
  a08=(a08-a14);
  a08=(a08/a09);
  a14=arg[0]? arg[0][1] : 0;
  a15=(a08*a14);
  a11=(a11+a15);
  a13=(a06*a13);
  a13=(a13+a00);
  a03=(a05*a03);
  a13=(a13-a03);
  a13=(a13/a09);
  a03=arg[0]? arg[0][2] : 0;
  a15=(a13*a03);
  a11=(a11+a15);
  if (res[0]!=0) res[0][0]=a11;
  a11=arg[0]? arg[0][3] : 0;
  a15=(a04*a11);
  a16=arg[0]? arg[0][4] : 0;
  a17=(a08*a16);
  a15=(a15+a17);
  a17=arg[0]? arg[0][5] : 0;
  a18=(a13*a17);
  a15=(a15+a18);
  if (res[0]!=0) res[0][1]=a15;
  a15=arg[0]? arg[0][6] : 0;
  a04=(a04*a15);
  a18=arg[0]? arg[0][7] : 0;
  a08=(a08*a18);
  a04=(a04+a08);
  a08=arg[0]? arg[0][8] : 0;
  a13=(a13*a08);
  a04=(a04+a13);
  if (res[0]!=0) res[0][2]=a04;
  a04=0.;
  if (res[1]!=0) res[1][0]=a04;
  a13=(a01*a02);
  a19=(a00*a13);
  a19=(a19+a05);
  a20=(a01*a07);
  a21=(a06*a20);
  a19=(a19-a21);
  a19=(a19/a09);
  a21=(a19*a15);
  a20=(a05*a20);
  a20=(a20+a06);
  a22=(a01*a12);
  a23=(a00*a22);
  a20=(a20-a23);
  a20=(a20/a09);
  a23=(a20*a18);
  a21=(a21+a23);
  a22=(a06*a22);
  a22=(a22+a00);
  a13=(a05*a13);
  a22=(a22-a13);
  a22=(a22/a09);
  a13=(a22*a08);
  a21=(a21+a13);
  if (res[1]!=0) res[1][1]=a21;
  a21=(a19*a11);
  a13=(a20*a16);
  a21=(a21+a13);
  a13=(a22*a17);
  a21=(a21+a13);
  a21=(-a21);
  if (res[1]!=0) res[1][2]=a21;
  a21=(a19*a15);
  a13=(a20*a18);
  a21=(a21+a13);
  a13=(a22*a08);
  a21=(a21+a13);
  a21=(-a21);
  if (res[1]!=0) res[1][3]=a21;
  if (res[1]!=0) res[1][4]=a04;
  a21=(a19*a10);
  a13=(a20*a14);
  a21=(a21+a13);
  a13=(a22*a03);
  a21=(a21+a13);
  if (res[1]!=0) res[1][5]=a21;
  a21=(a19*a11);
  a13=(a20*a16);
  a21=(a21+a13);
  a13=(a22*a17);
  a21=(a21+a13);
  if (res[1]!=0) res[1][6]=a21;
  a19=(a19*a10);
  a20=(a20*a14);
  a19=(a19+a20);
  a22=(a22*a03);
  a19=(a19+a22);
  a19=(-a19);
  if (res[1]!=0) res[1][7]=a19;
  if (res[1]!=0) res[1][8]=a04;
  a04=(a01*a06);
  a04=(a04/a09);
  a19=(a03*a04);
  a22=(a01*a00);
  a22=(a22/a09);
  a20=(a14*a22);
  a19=(a19-a20);
  if (res[2]!=0) res[2][0]=a19;
  a19=(a17*a04);
  a20=(a16*a22);
  a19=(a19-a20);
  if (res[2]!=0) res[2][1]=a19;
  a04=(a08*a04);
  a22=(a18*a22);
  a04=(a04-a22);
  if (res[2]!=0) res[2][2]=a04;
  a04=(a01*a00);
  a04=(a04/a09);
  a22=(a10*a04);
  a19=(a01*a05);
  a19=(a19/a09);
  a20=(a03*a19);
  a22=(a22-a20);
  if (res[2]!=0) res[2][3]=a22;
  a22=(a11*a04);
  a20=(a17*a19);
  a22=(a22-a20);
  if (res[2]!=0) res[2][4]=a22;
  a04=(a15*a04);
  a19=(a08*a19);
  a04=(a04-a19);
  if (res[2]!=0) res[2][5]=a04;
  a04=(a01*a05);
  a04=(a04/a09);
  a19=(a14*a04);
  a22=(a01*a06);
  a22=(a22/a09);
  a20=(a10*a22);
  a19=(a19-a20);
  if (res[2]!=0) res[2][6]=a19;
  a19=(a16*a04);
  a20=(a11*a22);
  a19=(a19-a20);
  if (res[2]!=0) res[2][7]=a19;
  a04=(a18*a04);
  a22=(a15*a22);
  a04=(a04-a22);
  if (res[2]!=0) res[2][8]=a04;
  a04=(a10/a09);
  a22=(a01*a07);
  a19=(a22/a09);
  a20=(a14*a19);
  a04=(a04+a20);
  a20=(a01*a02);
  a21=(a20/a09);
  a13=(a03*a21);
  a04=(a04-a13);
  if (res[3]!=0) res[3][0]=a04;
  a04=(a11/a09);
  a13=(a16*a19);
  a04=(a04+a13);
  a13=(a17*a21);
  a04=(a04-a13);
  if (res[3]!=0) res[3][1]=a04;
  a04=(a15/a09);
  a19=(a18*a19);
  a04=(a04+a19);
  a21=(a08*a21);
  a04=(a04-a21);
  if (res[3]!=0) res[3][2]=a04;
  a04=(a14/a09);
  a22=(a22/a09);
  a21=(a10*a22);
  a04=(a04-a21);
  a21=(a01*a12);
  a19=(a21/a09);
  a13=(a03*a19);
  a04=(a04+a13);
  if (res[3]!=0) res[3][3]=a04;
  a04=(a16/a09);
  a13=(a11*a22);
  a04=(a04-a13);
  a13=(a17*a19);
  a04=(a04+a13);
  if (res[3]!=0) res[3][4]=a04;
  a04=(a18/a09);
  a22=(a15*a22);
  a04=(a04-a22);
  a19=(a08*a19);
  a04=(a04+a19);
  if (res[3]!=0) res[3][5]=a04;
  a20=(a20/a09);
  a04=(a10*a20);
  a21=(a21/a09);
  a19=(a14*a21);
  a04=(a04-a19);
  a19=(a03/a09);
  a04=(a04+a19);
  if (res[3]!=0) res[3][6]=a04;
  a04=(a11*a20);
  a19=(a16*a21);
  a04=(a04-a19);
  a19=(a17/a09);
  a04=(a04+a19);
  if (res[3]!=0) res[3][7]=a04;
  a20=(a15*a20);
  a21=(a18*a21);
  a20=(a20-a21);
  a21=(a08/a09);
  a20=(a20+a21);
  if (res[3]!=0) res[3][8]=a20;
  a02=(a01*a02);
  a20=(a00*a02);
  a20=(a20+a05);
  a07=(a01*a07);
  a21=(a06*a07);
  a20=(a20-a21);
  a20=(a20/a09);
  a20=(a20/a09);
  a10=(a10*a20);
  a07=(a05*a07);
  a07=(a07+a06);
  a01=(a01*a12);
  a12=(a00*a01);
  a07=(a07-a12);
  a07=(a07/a09);
  a07=(a07/a09);
  a14=(a14*a07);
  a10=(a10+a14);
  a06=(a06*a01);
  a06=(a06+a00);
  a05=(a05*a02);
  a06=(a06-a05);
  a06=(a06/a09);
  a06=(a06/a09);
  a03=(a03*a06);
  a10=(a10+a03);
  a10=(-a10);
  if (res[4]!=0) res[4][0]=a10;
  a11=(a11*a20);
  a16=(a16*a07);
  a11=(a11+a16);
  a17=(a17*a06);
  a11=(a11+a17);
  a11=(-a11);
  if (res[4]!=0) res[4][1]=a11;
  a15=(a15*a20);
  a18=(a18*a07);
  a15=(a15+a18);
  a08=(a08*a06);
  a15=(a15+a08);
  a15=(-a15);
  if (res[4]!=0) res[4][2]=a15;
  return 0;
}

CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_calc_force(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_calc_force_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void navtk_specific_force_casadi_calc_force_release(int mem) {
}

CASADI_SYMBOL_EXPORT void navtk_specific_force_casadi_calc_force_incref(void) {
}

CASADI_SYMBOL_EXPORT void navtk_specific_force_casadi_calc_force_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int navtk_specific_force_casadi_calc_force_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int navtk_specific_force_casadi_calc_force_n_out(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_real navtk_specific_force_casadi_calc_force_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* navtk_specific_force_casadi_calc_force_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* navtk_specific_force_casadi_calc_force_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    case 3: return "o3";
    case 4: return "o4";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* navtk_specific_force_casadi_calc_force_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* navtk_specific_force_casadi_calc_force_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s3;
    case 2: return casadi_s3;
    case 3: return casadi_s3;
    case 4: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_calc_force_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_calc_force_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* navtk_specific_force_casadi_force:(i0[16],i1[3],i2[3],i3)->(o0[3],o1[3x15],o2[3x3],o3[3x3],o4[3]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43;
  a00=1.;
  a01=arg[0]? arg[0][8] : 0;
  a02=(2.*a01);
  a03=(a02*a01);
  a04=(a00-a03);
  a05=arg[0]? arg[0][9] : 0;
  a06=(2.*a05);
  a07=(a06*a05);
  a04=(a04-a07);
  a08=5.0000000000000000e-01;
  a09=arg[1]? arg[1][1] : 0;
  a10=arg[3]? arg[3][0] : 0;
  a11=arg[0]? arg[0][14] : 0;
  a12=(a10*a11);
  a12=(a09-a12);
  a12=(a08*a12);
  a13=arg[2]? arg[2][2] : 0;
  a14=arg[0]? arg[0][12] : 0;
  a15=(a14*a10);
  a15=(a13-a15);
  a16=(a12*a15);
  a17=arg[2]? arg[2][0] : 0;
  a18=arg[0]? arg[0][10] : 0;
  a19=(a18*a10);
  a19=(a17-a19);
  a16=(a16+a19);
  a20=arg[1]? arg[1][2] : 0;
  a21=arg[0]? arg[0][15] : 0;
  a22=(a10*a21);
  a22=(a20-a22);
  a22=(a08*a22);
  a23=arg[2]? arg[2][1] : 0;
  a24=arg[0]? arg[0][11] : 0;
  a25=(a24*a10);
  a25=(a23-a25);
  a26=(a22*a25);
  a16=(a16-a26);
  a16=(a16/a10);
  a04=(a04*a16);
  a26=arg[0]? arg[0][7] : 0;
  a27=(a02*a26);
  a28=arg[0]? arg[0][6] : 0;
  a29=(a06*a28);
  a30=(a27-a29);
  a22=(a22*a19);
  a22=(a22+a25);
  a31=arg[1]? arg[1][0] : 0;
  a32=arg[0]? arg[0][13] : 0;
  a33=(a10*a32);
  a33=(a31-a33);
  a33=(a08*a33);
  a34=(a33*a15);
  a22=(a22-a34);
  a22=(a22/a10);
  a30=(a30*a22);
  a04=(a04+a30);
  a02=(a02*a28);
  a30=(a06*a26);
  a34=(a02+a30);
  a33=(a33*a25);
  a33=(a33+a15);
  a12=(a12*a19);
  a33=(a33-a12);
  a33=(a33/a10);
  a34=(a34*a33);
  a04=(a04+a34);
  if (res[0]!=0) res[0][0]=a04;
  a29=(a29+a27);
  a29=(a29*a16);
  a27=(2.*a26);
  a04=(a27*a26);
  a34=(a00-a04);
  a34=(a34-a07);
  a34=(a34*a22);
  a29=(a29+a34);
  a06=(a06*a01);
  a27=(a27*a28);
  a34=(a06-a27);
  a34=(a34*a33);
  a29=(a29+a34);
  if (res[0]!=0) res[0][1]=a29;
  a30=(a30-a02);
  a30=(a30*a16);
  a27=(a27+a06);
  a27=(a27*a22);
  a30=(a30+a27);
  a04=(a00-a04);
  a04=(a04-a03);
  a04=(a04*a33);
  a30=(a30+a04);
  if (res[0]!=0) res[0][2]=a30;
  a30=0.;
  if (res[1]!=0) res[1][0]=a30;
  if (res[1]!=0) res[1][1]=a30;
  if (res[1]!=0) res[1][2]=a30;
  if (res[1]!=0) res[1][3]=a30;
  if (res[1]!=0) res[1][4]=a30;
  if (res[1]!=0) res[1][5]=a30;
  if (res[1]!=0) res[1][6]=a30;
  if (res[1]!=0) res[1][7]=a30;
  if (res[1]!=0) res[1][8]=a30;
  if (res[1]!=0) res[1][9]=a30;
  if (res[1]!=0) res[1][10]=a30;
  if (res[1]!=0) res[1][11]=a30;
  if (res[1]!=0) res[1][12]=a30;
  if (res[1]!=0) res[1][13]=a30;
  if (res[1]!=0) res[1][14]=a30;
  if (res[1]!=0) res[1][15]=a30;
  if (res[1]!=0) res[1][16]=a30;
  if (res[1]!=0) res[1][17]=a30;
  a30=(2.*a01);
  a04=(a10*a32);
  a04=(a31-a04);
  a04=(a08*a04);
  a33=(a24*a10);
  a33=(a23-a33);
  a03=(a04*a33);
  a27=(a14*a10);
  a27=(a13-a27);
  a03=(a03+a27);
  a22=(a10*a11);
  a22=(a09-a22);
  a22=(a08*a22);
  a06=(a18*a10);
  a06=(a17-a06);
  a16=(a22*a06);
  a03=(a03-a16);
  a03=(a03/a10);
  a16=(a30*a03);
  a02=(2.*a05);
  a29=(a10*a21);
  a29=(a20-a29);
  a29=(a08*a29);
  a34=(a29*a06);
  a34=(a34+a33);
  a07=(a04*a27);
  a34=(a34-a07);
  a34=(a34/a10);
  a07=(a02*a34);
  a16=(a16-a07);
  a07=(a26*a16);
  a12=(a02*a03);
  a19=(a30*a34);
  a12=(a12+a19);
  a19=(a28*a12);
  a07=(a07-a19);
  a19=(a26*a03);
  a15=(a28*a34);
  a19=(a19-a15);
  a15=(a22*a27);
  a15=(a15+a06);
  a25=(a29*a33);
  a15=(a15-a25);
  a15=(a15/a10);
  a25=(a05*a15);
  a19=(a19-a25);
  a19=(2.*a19);
  a25=(a02*a15);
  a19=(a19-a25);
  a25=(a01*a19);
  a07=(a07-a25);
  a25=(a28*a03);
  a35=(a26*a34);
  a25=(a25+a35);
  a35=(a01*a15);
  a25=(a25-a35);
  a25=(2.*a25);
  a35=(a30*a15);
  a25=(a25-a35);
  a35=(a05*a25);
  a07=(a07+a35);
  a07=(a08*a07);
  if (res[1]!=0) res[1][18]=a07;
  a07=(a02*a15);
  a35=(2.*a26);
  a36=(a35*a03);
  a07=(a07-a36);
  a36=(a26*a07);
  a37=(a28*a03);
  a38=(a26*a34);
  a37=(a37+a38);
  a37=(-a37);
  a37=(2.*a37);
  a38=(a35*a34);
  a37=(a37-a38);
  a38=(a30*a15);
  a37=(a37+a38);
  a38=(a28*a37);
  a36=(a36-a38);
  a38=(a01*a03);
  a39=(a28*a15);
  a38=(a38+a39);
  a39=(a05*a34);
  a38=(a38-a39);
  a38=(2.*a38);
  a39=(a02*a34);
  a38=(a38-a39);
  a39=(a01*a38);
  a36=(a36-a39);
  a39=(a02*a03);
  a40=(a26*a15);
  a40=(2.*a40);
  a39=(a39+a40);
  a40=(a05*a39);
  a36=(a36+a40);
  a36=(a08*a36);
  if (res[1]!=0) res[1][19]=a36;
  a36=(a35*a34);
  a40=(a30*a15);
  a36=(a36-a40);
  a40=(a26*a36);
  a41=(a28*a34);
  a42=(a26*a03);
  a41=(a41-a42);
  a41=(2.*a41);
  a42=(a35*a03);
  a41=(a41-a42);
  a42=(a02*a15);
  a41=(a41+a42);
  a42=(a28*a41);
  a40=(a40-a42);
  a42=(a01*a34);
  a43=(a26*a15);
  a42=(a42+a43);
  a42=(2.*a42);
  a43=(a01*a42);
  a40=(a40-a43);
  a34=(a02*a34);
  a43=(a30*a03);
  a34=(a34-a43);
  a15=(a28*a15);
  a03=(a01*a03);
  a15=(a15+a03);
  a15=(-a15);
  a15=(2.*a15);
  a34=(a34+a15);
  a15=(a05*a34);
  a40=(a40+a15);
  a40=(a08*a40);
  if (res[1]!=0) res[1][20]=a40;
  a40=(a01*a16);
  a15=(a05*a12);
  a40=(a40-a15);
  a15=(a26*a19);
  a40=(a40+a15);
  a15=(a28*a25);
  a40=(a40-a15);
  a40=(a08*a40);
  if (res[1]!=0) res[1][21]=a40;
  a40=(a01*a07);
  a15=(a05*a37);
  a40=(a40-a15);
  a15=(a26*a38);
  a40=(a40+a15);
  a15=(a28*a39);
  a40=(a40-a15);
  a40=(a08*a40);
  if (res[1]!=0) res[1][22]=a40;
  a40=(a01*a36);
  a15=(a05*a41);
  a40=(a40-a15);
  a15=(a26*a42);
  a40=(a40+a15);
  a15=(a28*a34);
  a40=(a40-a15);
  a40=(a08*a40);
  if (res[1]!=0) res[1][23]=a40;
  a16=(a05*a16);
  a12=(a01*a12);
  a16=(a16+a12);
  a19=(a28*a19);
  a16=(a16-a19);
  a25=(a26*a25);
  a16=(a16-a25);
  a16=(a08*a16);
  if (res[1]!=0) res[1][24]=a16;
  a07=(a05*a07);
  a37=(a01*a37);
  a07=(a07+a37);
  a38=(a28*a38);
  a07=(a07-a38);
  a39=(a26*a39);
  a07=(a07-a39);
  a07=(a08*a07);
  if (res[1]!=0) res[1][25]=a07;
  a36=(a05*a36);
  a41=(a01*a41);
  a36=(a36+a41);
  a42=(a28*a42);
  a36=(a36-a42);
  a34=(a26*a34);
  a36=(a36-a34);
  a36=(a08*a36);
  if (res[1]!=0) res[1][26]=a36;
  a36=(a30*a26);
  a34=(a02*a28);
  a42=(a36-a34);
  a42=(a42/a10);
  a41=(a29*a42);
  a07=(a30*a28);
  a39=(a02*a26);
  a38=(a07+a39);
  a38=(a38/a10);
  a37=(a22*a38);
  a41=(a41-a37);
  a30=(a30*a01);
  a37=(a00-a30);
  a16=(a02*a05);
  a37=(a37-a16);
  a37=(a37/a10);
  a41=(a41+a37);
  a41=(a10*a41);
  a41=(-a41);
  if (res[1]!=0) res[1][27]=a41;
  a41=(a35*a26);
  a25=(a00-a41);
  a25=(a25-a16);
  a25=(a25/a10);
  a16=(a29*a25);
  a02=(a02*a01);
  a35=(a35*a28);
  a19=(a02-a35);
  a19=(a19/a10);
  a12=(a22*a19);
  a16=(a16-a12);
  a34=(a34+a36);
  a34=(a34/a10);
  a16=(a16+a34);
  a16=(a10*a16);
  a16=(-a16);
  if (res[1]!=0) res[1][28]=a16;
  a35=(a35+a02);
  a35=(a35/a10);
  a02=(a29*a35);
  a41=(a00-a41);
  a41=(a41-a30);
  a41=(a41/a10);
  a30=(a22*a41);
  a02=(a02-a30);
  a39=(a39-a07);
  a39=(a39/a10);
  a02=(a02+a39);
  a02=(a10*a02);
  a02=(-a02);
  if (res[1]!=0) res[1][29]=a02;
  a02=(a04*a38);
  a02=(a02+a42);
  a07=(a29*a37);
  a02=(a02-a07);
  a02=(a10*a02);
  a02=(-a02);
  if (res[1]!=0) res[1][30]=a02;
  a02=(a04*a19);
  a02=(a02+a25);
  a07=(a29*a34);
  a02=(a02-a07);
  a02=(a10*a02);
  a02=(-a02);
  if (res[1]!=0) res[1][31]=a02;
  a02=(a04*a41);
  a02=(a02+a35);
  a29=(a29*a39);
  a02=(a02-a29);
  a02=(a10*a02);
  a02=(-a02);
  if (res[1]!=0) res[1][32]=a02;
  a02=(a04*a42);
  a02=(a38-a02);
  a29=(a22*a37);
  a02=(a02+a29);
  a02=(a10*a02);
  a02=(-a02);
  if (res[1]!=0) res[1][33]=a02;
  a02=(a04*a25);
  a02=(a19-a02);
  a29=(a22*a34);
  a02=(a02+a29);
  a02=(a10*a02);
  a02=(-a02);
  if (res[1]!=0) res[1][34]=a02;
  a04=(a04*a35);
  a04=(a41-a04);
  a22=(a22*a39);
  a04=(a04+a22);
  a04=(a10*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][35]=a04;
  a04=(a33*a38);
  a22=(a27*a42);
  a04=(a04-a22);
  a04=(a08*a04);
  a04=(a10*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][36]=a04;
  a04=(a33*a19);
  a22=(a27*a25);
  a04=(a04-a22);
  a04=(a08*a04);
  a04=(a10*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][37]=a04;
  a04=(a33*a41);
  a22=(a27*a35);
  a04=(a04-a22);
  a04=(a08*a04);
  a04=(a10*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][38]=a04;
  a04=(a27*a37);
  a38=(a06*a38);
  a04=(a04-a38);
  a04=(a08*a04);
  a04=(a10*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][39]=a04;
  a04=(a27*a34);
  a19=(a06*a19);
  a04=(a04-a19);
  a04=(a08*a04);
  a04=(a10*a04);
  a04=(-a04);
  if (res[1]!=0) res[1][40]=a04;
  a27=(a27*a39);
  a41=(a06*a41);
  a27=(a27-a41);
  a27=(a08*a27);
  a27=(a10*a27);
  a27=(-a27);
  if (res[1]!=0) res[1][41]=a27;
  a42=(a06*a42);
  a37=(a33*a37);
  a42=(a42-a37);
  a42=(a08*a42);
  a42=(a10*a42);
  a42=(-a42);
  if (res[1]!=0) res[1][42]=a42;
  a25=(a06*a25);
  a34=(a33*a34);
  a25=(a25-a34);
  a25=(a08*a25);
  a25=(a10*a25);
  a25=(-a25);
  if (res[1]!=0) res[1][43]=a25;
  a06=(a06*a35);
  a33=(a33*a39);
  a06=(a06-a33);
  a06=(a08*a06);
  a06=(a10*a06);
  a06=(-a06);
  if (res[1]!=0) res[1][44]=a06;
  a06=(2.*a01);
  a33=(a06*a28);
  a39=(2.*a05);
  a35=(a39*a26);
  a25=(a33+a35);
  a34=(a24*a10);
  a34=(a23-a34);
  a42=(a08*a34);
  a42=(a42/a10);
  a37=(a25*a42);
  a27=(a06*a26);
  a41=(a39*a28);
  a04=(a27-a41);
  a19=(a14*a10);
  a19=(a13-a19);
  a38=(a08*a19);
  a38=(a38/a10);
  a22=(a04*a38);
  a37=(a37-a22);
  if (res[2]!=0) res[2][0]=a37;
  a37=(a39*a01);
  a22=(2.*a26);
  a02=(a22*a28);
  a29=(a37-a02);
  a07=(a29*a42);
  a22=(a22*a26);
  a30=(a00-a22);
  a39=(a39*a05);
  a30=(a30-a39);
  a16=(a30*a38);
  a07=(a07-a16);
  if (res[2]!=0) res[2][1]=a07;
  a22=(a00-a22);
  a06=(a06*a01);
  a22=(a22-a06);
  a42=(a22*a42);
  a02=(a02+a37);
  a38=(a02*a38);
  a42=(a42-a38);
  if (res[2]!=0) res[2][2]=a42;
  a06=(a00-a06);
  a06=(a06-a39);
  a19=(a08*a19);
  a19=(a19/a10);
  a39=(a06*a19);
  a42=(a18*a10);
  a42=(a17-a42);
  a38=(a08*a42);
  a38=(a38/a10);
  a25=(a25*a38);
  a39=(a39-a25);
  if (res[2]!=0) res[2][3]=a39;
  a41=(a41+a27);
  a27=(a41*a19);
  a29=(a29*a38);
  a27=(a27-a29);
  if (res[2]!=0) res[2][4]=a27;
  a35=(a35-a33);
  a19=(a35*a19);
  a22=(a22*a38);
  a19=(a19-a22);
  if (res[2]!=0) res[2][5]=a19;
  a42=(a08*a42);
  a42=(a42/a10);
  a04=(a04*a42);
  a34=(a08*a34);
  a34=(a34/a10);
  a06=(a06*a34);
  a04=(a04-a06);
  if (res[2]!=0) res[2][6]=a04;
  a30=(a30*a42);
  a41=(a41*a34);
  a30=(a30-a41);
  if (res[2]!=0) res[2][7]=a30;
  a02=(a02*a42);
  a35=(a35*a34);
  a02=(a02-a35);
  if (res[2]!=0) res[2][8]=a02;
  a02=(2.*a01);
  a35=(a02*a01);
  a34=(a00-a35);
  a42=(2.*a05);
  a30=(a42*a05);
  a34=(a34-a30);
  a41=(a34/a10);
  a04=(a02*a26);
  a06=(a42*a28);
  a19=(a04-a06);
  a22=(a10*a21);
  a22=(a20-a22);
  a22=(a08*a22);
  a38=(a22/a10);
  a33=(a19*a38);
  a41=(a41+a33);
  a02=(a02*a28);
  a33=(a42*a26);
  a27=(a02+a33);
  a29=(a10*a11);
  a29=(a09-a29);
  a29=(a08*a29);
  a39=(a29/a10);
  a25=(a27*a39);
  a41=(a41-a25);
  if (res[3]!=0) res[3][0]=a41;
  a06=(a06+a04);
  a04=(a06/a10);
  a41=(2.*a26);
  a25=(a41*a26);
  a37=(a00-a25);
  a37=(a37-a30);
  a30=(a37*a38);
  a04=(a04+a30);
  a42=(a42*a01);
  a41=(a41*a28);
  a30=(a42-a41);
  a07=(a30*a39);
  a04=(a04-a07);
  if (res[3]!=0) res[3][1]=a04;
  a33=(a33-a02);
  a02=(a33/a10);
  a41=(a41+a42);
  a38=(a41*a38);
  a02=(a02+a38);
  a25=(a00-a25);
  a25=(a25-a35);
  a39=(a25*a39);
  a02=(a02-a39);
  if (res[3]!=0) res[3][2]=a02;
  a02=(a19/a10);
  a22=(a22/a10);
  a39=(a34*a22);
  a02=(a02-a39);
  a39=(a10*a32);
  a39=(a31-a39);
  a39=(a08*a39);
  a35=(a39/a10);
  a38=(a27*a35);
  a02=(a02+a38);
  if (res[3]!=0) res[3][3]=a02;
  a02=(a37/a10);
  a38=(a06*a22);
  a02=(a02-a38);
  a38=(a30*a35);
  a02=(a02+a38);
  if (res[3]!=0) res[3][4]=a02;
  a02=(a41/a10);
  a22=(a33*a22);
  a02=(a02-a22);
  a35=(a25*a35);
  a02=(a02+a35);
  if (res[3]!=0) res[3][5]=a02;
  a29=(a29/a10);
  a34=(a34*a29);
  a39=(a39/a10);
  a19=(a19*a39);
  a34=(a34-a19);
  a27=(a27/a10);
  a34=(a34+a27);
  if (res[3]!=0) res[3][6]=a34;
  a06=(a06*a29);
  a37=(a37*a39);
  a06=(a06-a37);
  a30=(a30/a10);
  a06=(a06+a30);
  if (res[3]!=0) res[3][7]=a06;
  a33=(a33*a29);
  a41=(a41*a39);
  a33=(a33-a41);
  a25=(a25/a10);
  a33=(a33+a25);
  if (res[3]!=0) res[3][8]=a33;
  a33=(2.*a01);
  a25=(a33*a01);
  a41=(a00-a25);
  a39=(2.*a05);
  a05=(a39*a05);
  a41=(a41-a05);
  a29=(a24*a10);
  a23=(a23-a29);
  a29=(a08*a21);
  a06=(a23*a29);
  a21=(a10*a21);
  a20=(a20-a21);
  a20=(a08*a20);
  a21=(a20*a24);
  a06=(a06+a21);
  a21=(a14*a10);
  a13=(a13-a21);
  a21=(a08*a11);
  a30=(a13*a21);
  a11=(a10*a11);
  a09=(a09-a11);
  a09=(a08*a09);
  a11=(a09*a14);
  a30=(a30+a11);
  a30=(a30+a18);
  a06=(a06-a30);
  a06=(a06/a10);
  a30=(a09*a13);
  a11=(a18*a10);
  a17=(a17-a11);
  a30=(a30+a17);
  a11=(a20*a23);
  a30=(a30-a11);
  a30=(a30/a10);
  a30=(a30/a10);
  a06=(a06-a30);
  a41=(a41*a06);
  a30=(a33*a26);
  a11=(a39*a28);
  a37=(a30-a11);
  a34=(a08*a32);
  a27=(a13*a34);
  a32=(a10*a32);
  a31=(a31-a32);
  a08=(a08*a31);
  a31=(a08*a14);
  a27=(a27+a31);
  a29=(a17*a29);
  a31=(a20*a18);
  a29=(a29+a31);
  a29=(a29+a24);
  a27=(a27-a29);
  a27=(a27/a10);
  a20=(a20*a17);
  a20=(a20+a23);
  a29=(a08*a13);
  a20=(a20-a29);
  a20=(a20/a10);
  a20=(a20/a10);
  a27=(a27-a20);
  a37=(a37*a27);
  a41=(a41+a37);
  a33=(a33*a28);
  a37=(a39*a26);
  a20=(a33+a37);
  a21=(a17*a21);
  a18=(a09*a18);
  a21=(a21+a18);
  a34=(a23*a34);
  a24=(a08*a24);
  a34=(a34+a24);
  a34=(a34+a14);
  a21=(a21-a34);
  a21=(a21/a10);
  a08=(a08*a23);
  a08=(a08+a13);
  a09=(a09*a17);
  a08=(a08-a09);
  a08=(a08/a10);
  a08=(a08/a10);
  a21=(a21-a08);
  a20=(a20*a21);
  a41=(a41+a20);
  if (res[4]!=0) res[4][0]=a41;
  a11=(a11+a30);
  a11=(a11*a06);
  a30=(2.*a26);
  a26=(a30*a26);
  a41=(a00-a26);
  a41=(a41-a05);
  a41=(a41*a27);
  a11=(a11+a41);
  a39=(a39*a01);
  a30=(a30*a28);
  a28=(a39-a30);
  a28=(a28*a21);
  a11=(a11+a28);
  if (res[4]!=0) res[4][1]=a11;
  a37=(a37-a33);
  a37=(a37*a06);
  a30=(a30+a39);
  a30=(a30*a27);
  a37=(a37+a30);
  a00=(a00-a26);
  a00=(a00-a25);
  a00=(a00*a21);
  a37=(a37+a00);
  if (res[4]!=0) res[4][2]=a37;
  return 0;
}

CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_force(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_force_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void navtk_specific_force_casadi_force_release(int mem) {
}

CASADI_SYMBOL_EXPORT void navtk_specific_force_casadi_force_incref(void) {
}

CASADI_SYMBOL_EXPORT void navtk_specific_force_casadi_force_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int navtk_specific_force_casadi_force_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int navtk_specific_force_casadi_force_n_out(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_real navtk_specific_force_casadi_force_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* navtk_specific_force_casadi_force_name_in(casadi_int i) {
  switch (i) {
    case 0: return "i0";
    case 1: return "i1";
    case 2: return "i2";
    case 3: return "i3";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* navtk_specific_force_casadi_force_name_out(casadi_int i) {
  switch (i) {
    case 0: return "o0";
    case 1: return "o1";
    case 2: return "o2";
    case 3: return "o3";
    case 4: return "o4";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* navtk_specific_force_casadi_force_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s4;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* navtk_specific_force_casadi_force_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s5;
    case 2: return casadi_s3;
    case 3: return casadi_s3;
    case 4: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_force_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 5;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int navtk_specific_force_casadi_force_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 5*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


