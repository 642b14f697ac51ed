#include <asperity/contact_zone/scene_heat.h>
#include <asperity/contact_zone/scene_output.h>
#include <asperity/postprocess/polyline.h>
#include <asperity/postprocess/surface_picture.h>

#include <cmath>

namespace asperity
{
  template <>
  void
  SceneOutput<2>::write_tool(const unsigned int step, const double time)
  {
    Polyline           curve;
    const unsigned int n = 4 * scene.tool_surface.curve.knot_vector().n_spans();
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double x = scene.length * i / n;
        curve.points.emplace_back(x, scene.tool_surface.height(x));
      }
    files->tool.write(step, time, [&](std::ostream &out) {
      write_polyline(out, curve, time, step);
    });
  }



  template <>
  void
  SceneOutput<3>::write_tool(const unsigned int step, const double time)
  {
    const SplineSheet &sheet = scene.tool_surface.sheet;
    SurfacePicture     picture;
    constexpr double   squares_a_span = 2.;
    const unsigned int n[]            = {
                 static_cast<unsigned int>(squares_a_span *
                                sheet.knot_vector(0).n_spans()),
                 static_cast<unsigned int>(squares_a_span *
                                sheet.knot_vector(1).n_spans())};
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
        for (unsigned int corner = 0; corner < 4; ++corner)
          {
            const dealii::Point<2> at(scene.length * (i + corner % 2) / n[0],
                                      scene.width * (j + corner / 2) / n[1]);
            picture.points.emplace_back(at[0], at[1], sheet.value(at));
          }
    files->tool.write(step, time, [&](std::ostream &out) {
      write_surface(out, picture, time, step);
    });
  }



  namespace
  {
    /** What heat adds at the points of the contact, with its unit. */
    template <int dim>
    std::vector<std::pair<std::string, std::vector<double>>>
    fields_of_heat(const Scene<dim> &scene)
    {
      if (!scene.heat)
        return {};
      std::vector<double> chip = scene.heat->chip_temperature(),
                          tool = scene.heat->tool_temperature();
      for (std::size_t q = 0; q < chip.size(); ++q)
        {
          chip[q] -= 273.15;
          tool[q] -= 273.15;
        }
      return {{"temperature of the chip [degC]", chip},
              {"temperature of the tool [degC]", tool},
              {"heat flux into the tool [W/m^2]", scene.heat->flux_to_tool()}};
    }
  } // namespace



  template <>
  void
  SceneOutput<2>::write_contact(const dealii::Vector<double> &u,
                                const unsigned int            step,
                                const double                  time)
  {
    Polyline                          line;
    const auto                       &contact = *scene.contact;
    std::vector<double>               gap, oil_pressure;
    std::vector<dealii::Tensor<1, 2>> traction;
    const ShearTraction<2>           *shear = contact.shear();
    // per present length
    std::vector<double>       pressure = contact.pressure(), shear_traction;
    const std::vector<double> stretch  = contact.stretch(u);
    if (shear != nullptr)
      shear_traction = shear->at_points();
    for (std::size_t q = 0; q < pressure.size(); ++q)
      {
        pressure[q] /= stretch[q];
        gap.push_back(contact.gaps()[q].gap);
        oil_pressure.push_back(
          scene.lubricant ?
            scene.lubricant->pressure(contact.table().parameter[q]) :
            0.);
        traction.push_back(pressure[q] * contact.gaps()[q].normal);
        if (shear == nullptr)
          continue;
        shear_traction[q] /= stretch[q];
        traction.back() -= shear_traction[q] * shear->slip()[q].tangent[0];
      }
    line.points  = contact.positions();
    line.scalars = {{"contact pressure [Pa]", pressure},
                    {"oil pressure [Pa]", oil_pressure},
                    {"gap [m]", gap}};
    line.vectors = {{"traction [Pa]", traction}};
    if (shear != nullptr)
      {
        line.scalars.emplace_back("shear traction [Pa]", shear_traction);
        line.scalars.emplace_back("sticking [-]", shear->sticking());
      }
    for (const auto &[name, values] : fields_of_heat(scene))
      line.scalars.emplace_back(name, values);
    files->contact_line.write(step, time, [&](std::ostream &out) {
      write_polyline(out, line, time, step);
    });
  }



  template <>
  void
  SceneOutput<3>::write_contact(const dealii::Vector<double> &u,
                                const unsigned int            step,
                                const double                  time)
  {
    const auto               &contact = *scene.contact;
    const ShearTraction<3>   *shear   = contact.shear();
    const std::vector<double> stretch = contact.stretch(u);
    // per present area
    std::vector<double> pressure = contact.pressure(), gap, shear_traction,
                        oil_pressure;
    std::vector<dealii::Tensor<1, 3>> traction;
    for (std::size_t q = 0; q < pressure.size(); ++q)
      {
        pressure[q] /= stretch[q];
        gap.push_back(contact.gaps()[q].gap);
        const dealii::Point<3> &at = contact.table().parameter[q];
        oil_pressure.push_back(
          scene.lubricant ?
            scene.lubricant->pressure(dealii::Point<2>(at[0], at[1])) :
            0.);
        traction.push_back(pressure[q] * contact.gaps()[q].normal);
        if (shear == nullptr)
          continue;
        shear_traction.push_back(shear->size_at(q) / stretch[q]);
        for (unsigned int k = 0; k < 2; ++k)
          traction.back() -=
            shear->at_points(k)[q] / stretch[q] * shear->slip()[q].tangent[k];
      }
    const unsigned int n =
      std::lround(std::sqrt(contact.table().points_per_element));
    SurfacePicture picture;
    picture.points_a_side = n;
    picture.points        = from_gauss_points(contact.positions(), n, false);
    picture.vectors       = {
            {"traction [Pa]", from_gauss_points(traction, n, false)}};
    const auto add = [&](const std::string         &name,
                         const std::vector<double> &values) {
      picture.scalars.emplace_back(name, from_gauss_points(values, n, true));
    };
    add("contact pressure [Pa]", pressure);
    add("gap [m]", gap);
    if (scene.lubricant)
      add("oil pressure [Pa]", oil_pressure);
    if (shear != nullptr)
      {
        add("shear traction [Pa]", shear_traction);
        add("sticking [-]", shear->sticking());
      }
    for (const auto &[name, values] : fields_of_heat(scene))
      add(name, values);
    files->contact_line.write(step, time, [&](std::ostream &out) {
      write_surface(out, picture, time, step);
    });
  }
} // namespace asperity
