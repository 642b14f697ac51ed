#ifndef source_learning_blas_h
#define source_learning_blas_h

// The routines of BLAS and LAPACK that networks and orthogonal decompositions
// need. Matrices are stored by columns; the lengths of the one-letter texts are
// left out, as usual in C.
extern "C"
{
  void
  sgemm_(const char  *transpose_a,
         const char  *transpose_b,
         const int   *m,
         const int   *n,
         const int   *k,
         const float *alpha,
         const float *a,
         const int   *lda,
         const float *b,
         const int   *ldb,
         const float *beta,
         float       *c,
         const int   *ldc);

  void
  dgemm_(const char   *transpose_a,
         const char   *transpose_b,
         const int    *m,
         const int    *n,
         const int    *k,
         const double *alpha,
         const double *a,
         const int    *lda,
         const double *b,
         const int    *ldb,
         const double *beta,
         double       *c,
         const int    *ldc);

  /** A = U S V^T by divide and conquer. */
  void
  dgesdd_(const char *job,
          const int  *m,
          const int  *n,
          double     *a,
          const int  *lda,
          double     *s,
          double     *u,
          const int  *ldu,
          double     *vt,
          const int  *ldvt,
          double     *work,
          const int  *lwork,
          int        *iwork,
          int        *info);
}

namespace asperity
{
  /** C = alpha A B + beta C, A and B transposed if so said ('N', 'T').
   *  @param m,n,k rows and columns of C, and length of the sums */
  inline void
  gemm(const char   a_is,
       const char   b_is,
       const int    m,
       const int    n,
       const int    k,
       const float *a,
       const int    lda,
       const float *b,
       const int    ldb,
       const float  beta,
       float       *c,
       const int    ldc)
  {
    const float one = 1.f;
    sgemm_(&a_is, &b_is, &m, &n, &k, &one, a, &lda, b, &ldb, &beta, c, &ldc);
  }

  inline void
  gemm(const char    a_is,
       const char    b_is,
       const int     m,
       const int     n,
       const int     k,
       const double *a,
       const int     lda,
       const double *b,
       const int     ldb,
       const double  beta,
       double       *c,
       const int     ldc)
  {
    const double one = 1.;
    dgemm_(&a_is, &b_is, &m, &n, &k, &one, a, &lda, b, &ldb, &beta, c, &ldc);
  }
} // namespace asperity

#endif
