/*
 * asperity_friction.h: friction laws of Asperity for other programs.
 *
 * Copyright (c) the authors of Asperity
 *
 * Permission is hereby granted, free of charge, to any person obtaining a copy
 * of this software and associated documentation files (the "Software"), to deal
 * in the Software without restriction, including without limitation the rights
 * to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
 * copies of the Software, and to permit persons to whom the Software is
 * furnished to do so, subject to the following conditions:
 *
 * The above copyright notice and this permission notice shall be included in
 * all copies or substantial portions of the Software.
 *
 * THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
 * IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
 * FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
 * AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
 * LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
 * OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
 * SOFTWARE.
 */
#ifndef ASPERITY_FRICTION_H
#define ASPERITY_FRICTION_H

#include <stddef.h>

/*
 * The library libasperity_friction.so reads the file of a trained friction law
 * and answers at many contact points at once. C99, SI units: Pa, m/s, K.
 *
 * Every function but asperity_friction_load() and asperity_friction_free() only
 * reads the law, so that threads may share it without locks. No function
 * throws; those that return int return 0 if all went well, and otherwise a
 * number that is not 0, with a sentence in asperity_friction_last_error().
 */

#ifdef __cplusplus
extern "C"
{
#endif

#if defined(__GNUC__)
#  define ASPERITY_FRICTION_API __attribute__((visibility("default")))
#else
#  define ASPERITY_FRICTION_API
#endif

/* Changes when programs have to be compiled anew. */
#define ASPERITY_FRICTION_VERSION 1

  typedef struct asperity_friction_law asperity_friction_law;

  /* An input of a law and the box of its training data, in SI. The texts live
   * as long as the law. */
  typedef struct asperity_friction_input
  {
    const char *name;   /* "Load/Pressure" */
    const char *symbol; /* "p" */
    const char *unit;   /* for people: "MPa" */
    double      lower;
    double      upper;
  } asperity_friction_input;

  /* ASPERITY_FRICTION_VERSION of the library. */
  ASPERITY_FRICTION_API int
  asperity_friction_version(void);

  /* Reads a law's file; NULL if that fails. */
  ASPERITY_FRICTION_API asperity_friction_law *
  asperity_friction_load(const char *path);

  /* NULL is allowed. */
  ASPERITY_FRICTION_API void
  asperity_friction_free(asperity_friction_law *law);

  /* The sentence of the last failure in this thread, "" if there was none. It
   * is valid until the next failure in this thread. */
  ASPERITY_FRICTION_API const char *
  asperity_friction_last_error(void);

  /* Number of inputs; 0 for NULL. */
  ASPERITY_FRICTION_API size_t
  asperity_friction_n_inputs(const asperity_friction_law *law);

  ASPERITY_FRICTION_API int
  asperity_friction_get_input(const asperity_friction_law *law,
                              size_t                       index,
                              asperity_friction_input     *input);

  /*
   * mu at n contact points, for laws of no other inputs than pressure p,
   * velocity v and temperature T; those that a law does not have may be NULL.
   * Fails for other laws.
   *
   * dmu: 3 n derivatives, those of a point by p, v, T side by side, or NULL
   * sigma: n standard deviations of mu, or NULL
   * trusted: n times 1 if the point lies in the box of the training data and
   * the deviation is small, else 0; or NULL
   *
   * mu alone takes a fraction of the time of sigma and trusted.
   */
  ASPERITY_FRICTION_API int
  asperity_friction_eval(const asperity_friction_law *law,
                         size_t                       n,
                         const double                *p,
                         const double                *v,
                         const double                *T,
                         double                      *mu,
                         double                      *dmu,
                         double                      *sigma,
                         unsigned char               *trusted);

  /*
   * The same for any law. x: n points, their inputs side by side in the order
   * of asperity_friction_get_input(); dmu: as many derivatives, in the same
   * order.
   */
  ASPERITY_FRICTION_API int
  asperity_friction_eval_inputs(const asperity_friction_law *law,
                                size_t                       n,
                                const double                *x,
                                double                      *mu,
                                double                      *dmu,
                                double                      *sigma,
                                unsigned char               *trusted);

  /* The shear limit k [Pa] of the chip at n temperatures, for tau = min(mu p,
   * k); infinite if the law does not know it. */
  ASPERITY_FRICTION_API int
  asperity_friction_shear_limit(const asperity_friction_law *law,
                                size_t                       n,
                                const double                *T,
                                double                      *k);

  /* One sentence on which mechanisms make mu (ploughing, oil) and which are not
   * in it. It lives as long as the law; NULL for NULL. */
  ASPERITY_FRICTION_API const char *
  asperity_friction_mechanisms(const asperity_friction_law *law);

  /*
   * How far the profiles of the surface tell its mean; part of neither sigma
   * nor trusted, since all contact points share that error.
   *
   * n_profiles: over how many profiles mu is a mean
   * scatter: standard deviation between them, relative to mu; 0 for one
   * error: half width of the 95 % interval of the mean over the whole surface,
   * from their scatter alone, relative to mu (a factor exp(error) for a law of
   * ln(mu)); 0, that is unknown, for one
   */
  ASPERITY_FRICTION_API int
  asperity_friction_topography(const asperity_friction_law *law,
                               size_t                      *n_profiles,
                               double                      *scatter,
                               double                      *error);

#ifdef __cplusplus
}
#endif

#endif
