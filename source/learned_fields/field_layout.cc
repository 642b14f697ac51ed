#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/learned_fields/field_layout.h>

#include <algorithm>

namespace asperity
{
  FieldLayout::FieldLayout(const FieldSnapshots &about)
    : about_(about)
    , offsets(1, 0)
  {
    about_.snapshots.clear();
    for (std::size_t f = 0; f < n_fields(); ++f)
      offsets.push_back(offsets.back() + length(f));
  }



  const FieldSnapshots &
  FieldLayout::about() const
  {
    return about_;
  }



  unsigned int
  FieldLayout::n_times() const
  {
    return about_.shares.size();
  }



  std::size_t
  FieldLayout::n_fields() const
  {
    return about_.fields.size();
  }



  std::size_t
  FieldLayout::size() const
  {
    return n_times() * offsets.back();
  }



  std::size_t
  FieldLayout::offset(const unsigned int time, const std::size_t field) const
  {
    return time * offsets.back() + offsets[field];
  }



  std::size_t
  FieldLayout::length(const std::size_t field) const
  {
    const FieldKind &kind = about_.fields[field];
    return kind.n_components * about_.places.n_places(kind.places);
  }



  std::vector<double>
  FieldLayout::pack(const FieldSnapshots &run, const std::string &origin) const
  {
    const auto fail = [&](const std::string &found,
                          const std::string &expected) {
      throw InputError("The file " + quoted_name(origin) + " " + found +
                       "; the fields of one campaign have " + expected + ".");
    };
    if (!run.is_complete())
      fail("has " + std::to_string(run.snapshots.size()) + " of " +
             std::to_string(run.shares.size()) + " times",
           "all times");
    if (run.shares != about_.shares)
      fail("has other times", "the same times");
    if (!run.places.is_same_as(about_.places))
      fail("is of another mesh", "one mesh");
    const bool same_fields =
      std::equal(run.fields.begin(),
                 run.fields.end(),
                 about_.fields.begin(),
                 about_.fields.end(),
                 [](const FieldKind &a, const FieldKind &b) {
                   return a.name == b.name && a.places == b.places &&
                          a.n_components == b.n_components;
                 });
    if (!same_fields)
      fail("has other fields", "the same fields");
    std::vector<double> values;
    values.reserve(size());
    for (const FieldSnapshot &snapshot : run.snapshots)
      for (const std::vector<double> &field : snapshot.values)
        values.insert(values.end(), field.begin(), field.end());
    return values;
  }



  std::vector<std::vector<double>>
  FieldLayout::unpack(const std::vector<double> &values,
                      const unsigned int         time) const
  {
    std::vector<std::vector<double>> result;
    for (std::size_t f = 0; f < n_fields(); ++f)
      {
        const auto begin = values.begin() + offset(time, f);
        result.emplace_back(begin, begin + length(f));
      }
    return result;
  }



  double
  FieldLayout::squared_norm(const std::vector<double> &values,
                            const std::size_t          field) const
  {
    const FieldKind  &kind = about_.fields[field];
    const std::size_t n    = about_.places.n_places(kind.places);
    double            sum  = 0.;
    for (unsigned int time = 0; time < n_times(); ++time)
      for (std::size_t place = 0; place < n; ++place)
        for (unsigned int i = 0; i < kind.n_components; ++i)
          {
            const double value =
              values[offset(time, field) + place * kind.n_components + i];
            sum += about_.places.weight(kind.places, place) * value * value;
          }
    return sum;
  }



  std::vector<double>
  FieldLayout::weights(const std::vector<double> &variance) const
  {
    std::vector<double> result(size());
    for (unsigned int time = 0; time < n_times(); ++time)
      for (std::size_t f = 0; f < n_fields(); ++f)
        {
          const FieldKind &kind = about_.fields[f];
          for (std::size_t i = 0; i < length(f); ++i)
            result[offset(time, f) + i] =
              about_.places.weight(kind.places, i / kind.n_components) /
              variance[f];
        }
    return result;
  }
} // namespace asperity
