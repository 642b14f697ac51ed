#include <asperity/base/errors.h>
#include <asperity/base/mechanisms.h>
#include <asperity/base/text.h>
#include <asperity/surrogate/friction_law.h>

#include <asperity_friction.h>

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <string>
#include <vector>

struct asperity_friction_law
{
  explicit asperity_friction_law(const std::string &path)
    : law(asperity::FrictionLaw::load(path))
    , limit(law.description().shear_limit)
    , n_inputs(law.description().inputs.size())
    , mechanisms(asperity::mechanisms_sentence(law.description().mechanisms))
  {}

  const asperity::FrictionLaw law;
  const asperity::ShearLimit  limit;
  const std::size_t           n_inputs;
  const std::string           mechanisms;
};

namespace
{
  thread_local std::string last_error;

  /** Runs a function whose exceptions end here. */
  template <typename Function>
  int
  guarded(const Function &function)
  {
    try
      {
        function();
        return 0;
      }
    catch (const std::exception &error)
      {
        try
          {
            last_error = error.what();
          }
        catch (...)
          {
            last_error.clear(); // no memory for the sentence either
          }
      }
    catch (...)
      {
        last_error.clear();
      }
    return 1;
  }

  void
  require(const bool condition, const std::string &sentence)
  {
    if (!condition)
      throw asperity::InputError(sentence);
  }

  /** Points that are looked at together, so that the work arrays stay small. */
  constexpr std::size_t block_size = 256;

  /** Results of a block whose inputs lie side by side. */
  void
  evaluate(const asperity_friction_law &handle,
           const std::size_t            n,
           const double                *x,
           double                      *mu,
           double                      *gradient,
           double                      *sigma,
           unsigned char               *trusted)
  {
    const std::size_t d = handle.n_inputs;
    if (gradient == nullptr && sigma == nullptr && trusted == nullptr)
      {
        handle.law.means(n, x, mu);
        return;
      }
    for (std::size_t i = 0; i < n; ++i)
      {
        const asperity::LawPrediction at = handle.law.predict(x + i * d);
        mu[i]                            = at.mean;
        if (gradient != nullptr)
          std::copy(at.gradient.begin(), at.gradient.end(), gradient + i * d);
        if (sigma != nullptr)
          sigma[i] = at.deviation;
        if (trusted != nullptr)
          trusted[i] = at.trusted ? 1 : 0;
      }
  }

  /** For each input of the law the place among p, v and T. */
  std::vector<std::size_t>
  coordinates(const asperity::FrictionLaw         &law,
              const std::array<const double *, 3> &points)
  {
    const std::array<std::string, 3> symbols = {{"p", "v", "T"}};
    std::vector<std::size_t>         result;
    for (const asperity::LawInput &input : law.description().inputs)
      {
        const auto found =
          std::find(symbols.begin(), symbols.end(), input.symbol);
        require(found != symbols.end(),
                "The law depends on " + asperity::quoted_name(input.name) +
                  " beside p, v and T; asperity_friction_eval_inputs() "
                  "is expected.");
        result.push_back(static_cast<std::size_t>(found - symbols.begin()));
        require(points[result.back()] != nullptr,
                "The law depends on " + input.symbol +
                  ", but its array is NULL.");
      }
    return result;
  }
} // namespace



extern "C"
{
  int
  asperity_friction_version(void)
  {
    return ASPERITY_FRICTION_VERSION;
  }



  asperity_friction_law *
  asperity_friction_load(const char *path)
  {
    asperity_friction_law *result = nullptr;
    guarded([&] {
      require(path != nullptr, "The path of the friction law is NULL.");
      result = new asperity_friction_law(path);
    });
    return result;
  }



  void
  asperity_friction_free(asperity_friction_law *law)
  {
    delete law;
  }



  const char *
  asperity_friction_last_error(void)
  {
    return last_error.c_str();
  }



  size_t
  asperity_friction_n_inputs(const asperity_friction_law *law)
  {
    return law == nullptr ? 0 : law->n_inputs;
  }



  int
  asperity_friction_get_input(const asperity_friction_law *law,
                              size_t                       index,
                              asperity_friction_input     *result)
  {
    return guarded([&] {
      require(law != nullptr && result != nullptr,
              "The friction law or the place for its input is NULL.");
      require(index < law->n_inputs,
              "The law has " + std::to_string(law->n_inputs) +
                " inputs; there is none of index " + std::to_string(index) +
                ".");
      const asperity::LawInput &input = law->law.description().inputs[index];
      *result                         = {input.name.c_str(),
                                         input.symbol.c_str(),
                                         input.unit.c_str(),
                                         input.lower,
                                         input.upper};
    });
  }



  int
  asperity_friction_eval(const asperity_friction_law *law,
                         size_t                       n,
                         const double                *p,
                         const double                *v,
                         const double                *T,
                         double                      *mu,
                         double                      *dmu,
                         double                      *sigma,
                         unsigned char               *trusted)
  {
    return guarded([&] {
      require(law != nullptr && (mu != nullptr || n == 0),
              "The friction law or the array for mu is NULL.");
      if (n == 0)
        return;
      const std::array<const double *, 3> points = {{p, v, T}};
      const std::vector<std::size_t>      place = coordinates(law->law, points);

      const std::size_t   d = law->n_inputs;
      std::vector<double> x(block_size * d), gradient(block_size * d);
      for (std::size_t begin = 0; begin < n; begin += block_size)
        {
          const std::size_t size = std::min(block_size, n - begin);
          for (std::size_t i = 0; i < size; ++i)
            for (std::size_t c = 0; c < d; ++c)
              x[i * d + c] = points[place[c]][begin + i];
          evaluate(*law,
                   size,
                   x.data(),
                   mu + begin,
                   dmu == nullptr ? nullptr : gradient.data(),
                   sigma == nullptr ? nullptr : sigma + begin,
                   trusted == nullptr ? nullptr : trusted + begin);
          if (dmu == nullptr)
            continue;
          std::fill(dmu + 3 * begin, dmu + 3 * (begin + size), 0.);
          for (std::size_t i = 0; i < size; ++i)
            for (std::size_t c = 0; c < d; ++c)
              dmu[3 * (begin + i) + place[c]] = gradient[i * d + c];
        }
    });
  }



  int
  asperity_friction_eval_inputs(const asperity_friction_law *law,
                                size_t                       n,
                                const double                *x,
                                double                      *mu,
                                double                      *dmu,
                                double                      *sigma,
                                unsigned char               *trusted)
  {
    return guarded([&] {
      require(law != nullptr && (n == 0 || (x != nullptr && mu != nullptr)),
              "The friction law, its inputs or the array for mu is NULL.");
      evaluate(*law, n, x, mu, dmu, sigma, trusted);
    });
  }



  int
  asperity_friction_shear_limit(const asperity_friction_law *law,
                                size_t                       n,
                                const double                *T,
                                double                      *k)
  {
    return guarded([&] {
      require(law != nullptr && (n == 0 || (T != nullptr && k != nullptr)),
              "The friction law, the temperatures or the array for the shear "
              "limit is NULL.");
      for (std::size_t i = 0; i < n; ++i)
        k[i] = law->limit.k_0 > 0. ? law->limit(T[i]) :
                                     std::numeric_limits<double>::infinity();
    });
  }



  const char *
  asperity_friction_mechanisms(const asperity_friction_law *law)
  {
    return law == nullptr ? nullptr : law->mechanisms.c_str();
  }



  int
  asperity_friction_topography(const asperity_friction_law *law,
                               size_t                      *n_profiles,
                               double                      *scatter,
                               double                      *error)
  {
    return guarded([&] {
      require(law != nullptr && n_profiles != nullptr && scatter != nullptr &&
                error != nullptr,
              "The friction law or the place of one of its three results is "
              "NULL.");
      *n_profiles = law->law.description().n_profiles;
      *scatter    = law->law.description().topography_scatter;
      *error      = law->law.description().topography_error;
    });
  }
}
