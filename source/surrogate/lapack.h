#ifndef asperity_surrogate_lapack_h
#define asperity_surrogate_lapack_h

// The four routines of LAPACK that Gaussian processes need. Matrices are stored
// by columns; the lengths of the one-letter texts are left out, as usual in C.
extern "C"
{
  /** A = L L^T; info > 0: a pivot was not positive. */
  void
  dpotrf_(const char *uplo, const int *n, double *a, const int *lda, int *info);

  /** Solves A X = B by the factor of dpotrf. */
  void
  dpotrs_(const char   *uplo,
          const int    *n,
          const int    *n_rhs,
          const double *a,
          const int    *lda,
          double       *b,
          const int    *ldb,
          int          *info);

  /** A^-1 by the factor of dpotrf, one triangle of it. */
  void
  dpotri_(const char *uplo, const int *n, double *a, const int *lda, int *info);

  /** The inverse of a triangular matrix. */
  void
  dtrtri_(const char *uplo,
          const char *diag,
          const int  *n,
          double     *a,
          const int  *lda,
          int        *info);
}

#endif
