#include <asperity/learned_fields/network_decoder.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** m = 1, 2, 4, 8, 16: down to a sixteenth of the period. */
    constexpr unsigned int n_waves = 5;

    /** Depth over the height of the chip at which its logarithm levels off. */
    constexpr double shallow = 0.01;

    /** Polynomials through equidistant nodes at the Gauss points of [0, 1]. */
    std::vector<double>
    nodal_polynomials(const unsigned int n_subdivisions,
                      const unsigned int n_gauss)
    {
      const dealii::QGauss<1> gauss(n_gauss);
      std::vector<double>     values;
      for (unsigned int g = 0; g < n_gauss; ++g)
        for (unsigned int i = 0; i <= n_subdivisions; ++i)
          {
            double value = 1.;
            for (unsigned int j = 0; j <= n_subdivisions; ++j)
              if (j != i)
                value *= (gauss.point(g)[0] * n_subdivisions - j) /
                         (static_cast<double>(i) - static_cast<double>(j));
            values.push_back(value);
          }
      return values;
    }
  } // namespace



  NetworkPart::NetworkPart(const FieldLayout &layout, const bool is_edge)
    : layout(&layout)
    , is_edge(is_edge)
    , height(0.)
    , lagrange(nodal_polynomials(layout.about().places.n_subdivisions,
                                 layout.about().places.n_gauss))
  {
    const FieldPlaces &places = layout.about().places;
    for (std::size_t i = 1; i < places.nodes.size(); i += 3)
      height = std::max(height, places.nodes[i]);
    for (std::size_t f = 0; f < layout.n_fields(); ++f)
      {
        const FieldKind &kind = layout.about().fields[f];
        const bool       of_edge =
          kind.places == PlaceKind::edge || kind.places == PlaceKind::whole;
        if (of_edge != is_edge)
          continue;
        outputs.push_back({f, n});
        n += kind.n_components;
      }
  }



  unsigned int
  NetworkPart::n_outputs() const
  {
    return n;
  }



  unsigned int
  NetworkPart::n_coordinates() const
  {
    return 2 * n_waves + 1 + (is_edge ? 0 : 2);
  }



  PlaceKind
  NetworkPart::learnt_at() const
  {
    return is_edge ? PlaceKind::edge : PlaceKind::points;
  }



  std::vector<double>
  NetworkPart::positions(const PlaceKind kind) const
  {
    const FieldPlaces         &places = layout->about().places;
    const std::vector<double> &at = kind == PlaceKind::nodes ? places.nodes :
                                    kind == PlaceKind::edge  ? places.edge :
                                                               places.points;
    std::vector<double>        result;
    for (const double share : layout->about().shares)
      for (std::size_t i = 0; i < at.size(); i += 3)
        {
          for (unsigned int w = 0; w < n_waves; ++w)
            {
              const double angle =
                2. * M_PI * (1u << w) * at[i] / places.period;
              result.insert(result.end(), {std::cos(angle), std::sin(angle)});
            }
          result.push_back(share);
          if (!is_edge)
            result.insert(result.end(),
                          {at[i + 1],
                           std::log(shallow +
                                    std::max(0., 1. - at[i + 1] / height))});
        }
    return result;
  }



  double
  NetworkPart::at_gauss_point(const std::vector<double> &values,
                              const std::size_t          offset,
                              const std::size_t          point,
                              const unsigned int         n_components,
                              const unsigned int         component) const
  {
    const unsigned int m     = layout->about().places.n_gauss,
                       lines = layout->about().places.n_subdivisions + 1;
    const std::size_t cell = point / (m * m), g = point % (m * m);
    double            value = 0.;
    for (unsigned int j = 0; j < lines; ++j)
      for (unsigned int i = 0; i < lines; ++i)
        value +=
          lagrange[g % m * lines + i] * lagrange[g / m * lines + j] *
          values[offset + ((cell * lines + j) * lines + i) * n_components +
                 component];
    return value;
  }



  FieldSample
  NetworkPart::sample(const std::string         &name,
                      const std::vector<double> &values) const
  {
    const FieldSnapshots &about    = layout->about();
    const std::size_t     n_places = about.places.n_places(learnt_at());
    FieldSample           result{name, positions(learnt_at()), {}};
    for (unsigned int time = 0; time < layout->n_times(); ++time)
      for (std::size_t q = 0; q < n_places; ++q)
        for (const Output &output : outputs)
          {
            const FieldKind  &kind   = about.fields[output.field];
            const std::size_t offset = layout->offset(time, output.field);
            for (unsigned int c = 0; c < kind.n_components; ++c)
              result.values.push_back(
                kind.places == PlaceKind::whole ?
                  values[offset + c] :
                kind.places == PlaceKind::nodes ?
                  at_gauss_point(values, offset, q, kind.n_components, c) :
                  values[offset + q * kind.n_components + c]);
          }
    return result;
  }



  Scaling
  NetworkPart::position_scaling(const std::vector<FieldSample> &samples) const
  {
    Scaling result = scaling_of_positions(samples, n_coordinates());
    for (unsigned int c = 0; c < 2 * n_waves; ++c)
      {
        result.centre[c] = 0.;
        result.scale[c]  = 1.;
      }
    return result;
  }



  void
  NetworkPart::fill(const AutoDecoder        &network,
                    const std::vector<float> &code,
                    std::vector<double>      &values) const
  {
    const FieldSnapshots &about = layout->about();
    for (const PlaceKind at :
         {PlaceKind::nodes, PlaceKind::points, PlaceKind::edge})
      {
        if ((at == PlaceKind::edge) != is_edge)
          continue;
        const std::vector<double> y = network.evaluate(code, positions(at));
        const std::size_t         n_places = about.places.n_places(at);
        for (const Output &output : outputs)
          {
            const FieldKind &kind  = about.fields[output.field];
            const bool       whole = kind.places == PlaceKind::whole;
            if (kind.places != at && !whole)
              continue;
            for (unsigned int time = 0; time < layout->n_times(); ++time)
              for (std::size_t q = 0; q < n_places; ++q)
                for (unsigned int c = 0; c < kind.n_components; ++c)
                  {
                    const double value =
                      y[(time * n_places + q) * n + output.first + c];
                    double &to =
                      values[layout->offset(time, output.field) +
                             (whole ? 0 : q * kind.n_components) + c];
                    // what the whole chip has is the mean along the edge
                    to = whole ? to + value / n_places : value;
                  }
          }
      }
  }
} // namespace asperity
