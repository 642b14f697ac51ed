#include <asperity/splines/distance_certificate.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    constexpr unsigned int max_degree = CurvePieces::max_degree;

    /** The factors of products of Bernstein polynomials. */
    class Binomials
    {
    public:
      Binomials()
      {
        for (unsigned int n = 0; n <= 3 * max_degree; ++n)
          {
            table[n][0] = 1.;
            for (unsigned int k = 1; k <= n; ++k)
              table[n][k] = table[n][k - 1] * double(n - k + 1) / k;
          }
        for (unsigned int p = 1; p <= max_degree; ++p)
          for (unsigned int i = 0; i <= p; ++i)
            for (unsigned int j = 0; j <= p; ++j)
              squares[p][i][j] = factor(p, i, p, j);
      }

      /** Coefficient i + j of degree m + n in B_i^m B_j^n. */
      double
      factor(const unsigned int m,
             const unsigned int i,
             const unsigned int n,
             const unsigned int j) const
      {
        return table[m][i] * table[n][j] / table[m + n][i + j];
      }

      double squares[max_degree + 1][max_degree + 1][max_degree + 1];

    private:
      double table[3 * max_degree + 1][3 * max_degree + 1];
    };

    const Binomials binomials;



    /** a of degree p, squared, is added to the coefficients of degree 2 p. */
    void
    add_square(const double *a, const unsigned int p, double *result)
    {
      for (unsigned int i = 0; i <= p; ++i)
        {
          const double *factors = binomials.squares[p][i];
          result[2 * i] += factors[i] * a[i] * a[i];
          for (unsigned int j = i + 1; j <= p; ++j)
            result[i + j] += 2. * factors[j] * a[i] * a[j];
        }
    }



    /** De Casteljau at the middle: `right` holds the coefficients of the whole
     *  at first, then those of its right half. */
    void
    bisect(double *left, double *right, const unsigned int p)
    {
      left[0] = right[0];
      for (unsigned int k = 1; k <= p; ++k)
        {
          for (unsigned int i = 0; i <= p - k; ++i)
            right[i] = (right[i] + right[i + 1]) / 2.;
          left[k] = right[0];
        }
    }
  } // namespace



  /** Bernstein coefficients of polynomials on a part. */
  struct DistanceCertificate::Forms
  {
    double       squared_distance[2 * max_degree + 1]; ///< |C - P|^2 w^2
    double       squared_weight[2 * max_degree + 1];   ///< w^2
    double       derivative[3 * max_degree]; ///< of |C - P|^2, times w^3 > 0
    unsigned int derivative_degree;
    double       noise;            ///< round-off of squared_distance
    double       derivative_noise; ///< and of derivative
  };



  DistanceCertificate::DistanceCertificate(
    const CurvePieces               &pieces,
    const double                     px,
    const double                     py,
    const DistanceMinimizer         &minimizer,
    const DistanceMinimizer::Result &known)
    : pieces(pieces)
    , px(px)
    , py(py)
    , minimizer(minimizer)
    , best_point(known)
    , best_squared_distance(known.jet.squared_distance())
  {}



  void
  DistanceCertificate::examine(const unsigned int piece, const int turn)
  {
    Part          part;
    const double *points  = pieces.bernstein(piece);
    const double  shift_x = turn * pieces.period()[0] - px;
    const double  shift_y = turn * pieces.period()[1] - py;
    for (unsigned int i = 0; i <= pieces.degree(); ++i)
      {
        const double w = points[3 * i + 2];
        part.x[i]      = points[3 * i] + w * shift_x;
        part.y[i]      = points[3 * i + 1] + w * shift_y;
        part.w[i]      = w;
      }
    part.low  = -1.;
    part.high = 1.;
    CurveLocation location;
    location.piece            = piece;
    location.turn             = turn;
    const DistanceJet &known  = best_point.jet;
    const unsigned int middle = pieces.degree() / 2;
    if (is_beyond(part, known.rx, known.ry) ||
        is_beyond(part, part.x[middle], part.y[middle]))
      return;
    search(part, location, 0);
  }



  bool
  DistanceCertificate::is_beyond(const Part  &part,
                                 const double way_x,
                                 const double way_y) const
  {
    const double limit =
      best_squared_distance * (way_x * way_x + way_y * way_y);
    for (unsigned int i = 0; i <= pieces.degree(); ++i)
      {
        const double along = part.x[i] * way_x + part.y[i] * way_y;
        if (!(along > 0. && along * along >= limit * part.w[i] * part.w[i]))
          return false;
      }
    return true;
  }



  void
  DistanceCertificate::form_squared_distance(const Part &part,
                                             Forms      &forms) const
  {
    const unsigned int p = pieces.degree();
    std::fill_n(forms.squared_distance, 2 * p + 1, 0.);
    add_square(part.x, p, forms.squared_distance);
    add_square(part.y, p, forms.squared_distance);
    double reach2 = 0., weight = 1.;
    for (unsigned int i = 0; i <= p; ++i)
      reach2 = std::max(reach2, part.x[i] * part.x[i] + part.y[i] * part.y[i]);
    if (pieces.is_rational())
      {
        std::fill_n(forms.squared_weight, 2 * p + 1, 0.);
        add_square(part.w, p, forms.squared_weight);
        weight = *std::max_element(part.w, part.w + p + 1);
      }
    const double reach = std::sqrt(reach2);
    const double noise = weight * minimizer.position_noise();
    forms.noise        = 2. * noise * (reach + noise) + 1e-15 * reach2;
  }



  void
  DistanceCertificate::form_derivative(const Part &part, Forms &forms) const
  {
    const unsigned int p = pieces.degree();
    const double      *F = forms.squared_distance;
    if (!pieces.is_rational())
      {
        forms.derivative_degree = 2 * p - 1;
        for (unsigned int k = 0; k < 2 * p; ++k)
          forms.derivative[k] = F[k + 1] - F[k];
        forms.derivative_noise = forms.noise;
        return;
      }
    // (F / w^2)' w^3 / 2 = (F' w) / 2 - F w', divided by p
    forms.derivative_degree = 3 * p - 1;
    std::fill_n(forms.derivative, 3 * p, 0.);
    for (unsigned int i = 0; i < 2 * p; ++i)
      for (unsigned int j = 0; j <= p; ++j)
        forms.derivative[i + j] +=
          binomials.factor(2 * p - 1, i, p, j) * (F[i + 1] - F[i]) * part.w[j];
    for (unsigned int i = 0; i <= 2 * p; ++i)
      for (unsigned int j = 0; j < p; ++j)
        forms.derivative[i + j] -= binomials.factor(2 * p, i, p - 1, j) * F[i] *
                                   (part.w[j + 1] - part.w[j]);
    forms.derivative_noise =
      3. * forms.noise * *std::max_element(part.w, part.w + p + 1);
  }



  void
  DistanceCertificate::consider(CurveLocation location, const double s)
  {
    location.s            = s;
    const DistanceJet jet = pieces.jet(location, px, py);
    if (jet.squared_distance() < best_squared_distance)
      {
        best_squared_distance = jet.squared_distance();
        best_point.location   = location;
        best_point.jet        = jet;
        best_point.method     = Projection::Method::subdivision;
      }
  }



  void
  DistanceCertificate::search(const Part          &part,
                              const CurveLocation &location,
                              const unsigned int   depth)
  {
    const unsigned int p = pieces.degree();
    Forms              forms;
    form_squared_distance(part, forms);
    bool farther = true;
    for (unsigned int k = 0; k <= 2 * p && farther; ++k)
      farther = forms.squared_distance[k] + forms.noise >=
                best_squared_distance *
                  (pieces.is_rational() ? forms.squared_weight[k] : 1.);
    if (farther)
      return;

    form_derivative(part, forms);
    int first_sign = 0, last_sign = 0, n_changes = 0;
    for (unsigned int k = 0; k <= forms.derivative_degree; ++k)
      if (std::abs(forms.derivative[k]) > forms.derivative_noise)
        {
          const int sign = (forms.derivative[k] > 0. ? 1 : -1);
          if (first_sign == 0)
            first_sign = sign;
          else if (sign != last_sign)
            ++n_changes;
          last_sign = sign;
        }

    if (n_changes == 1 && first_sign < 0)
      {
        const CurveLocation &known = best_point.location;
        if (known.piece == location.piece && known.turn == location.turn &&
            known.s > part.low && known.s < part.high &&
            best_point.jet.hessian() > 1e-3 * best_point.jet.squared_speed() &&
            best_point.method != Projection::Method::none)
          return; // this part's only minimum is known, and to full accuracy
        const auto found =
          minimizer.minimize_between(location, part.low, part.high);
        consider(location, found.location.s);
        return;
      }
    if (n_changes <= 1 || part.high - part.low < 1e-12 || depth > 60)
      {
        // Monotone, or a single maximum: the ends are the candidates.
        consider(location, part.low);
        consider(location, part.high);
        return;
      }

    Part left = part, right = part;
    left.high = right.low = (part.low + part.high) / 2.;
    bisect(left.x, right.x, p);
    bisect(left.y, right.y, p);
    bisect(left.w, right.w, p);
    search(left, location, depth + 1);
    search(right, location, depth + 1);
  }
} // namespace asperity
