#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/contact_zone/oil_in_gap.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** What is beyond rounding. */
    constexpr double tolerance = 1e-9;

    std::string
    warning_of_flood(const LubricationParameters &lubrication,
                     const double                 asked_gap,
                     const double                 touch_gap,
                     const OilInGap              &oil)
    {
      if (oil.thickness <= touch_gap * (1. + tolerance))
        return "";
      const bool counts_start = lubrication.amount == OilAmount::void_at_start;
      if (counts_start && lubrication.wetting == 1.)
        return "";
      std::string text =
        "The gap is flooded: the oil of " +
        format_quantity(oil.thickness, "nm", 4) +
        " is more than the void holds when the surfaces touch, " +
        format_quantity(touch_gap, "nm", 4) +
        ", so that it is compressed before they do and carries the load";
      if (counts_start)
        text += "; Wetting = " + format_number(lubrication.wetting) +
                " counts the initial gap of " +
                format_quantity(asked_gap, "nm", 4) +
                " as void, Lubrication/Oil amount = part of void at touch "
                "would not";
      if (oil.initial_gap > asked_gap)
        text += "; the surfaces start " +
                format_quantity(oil.initial_gap, "nm", 4) +
                " apart instead of " + format_quantity(asked_gap, "nm", 4) +
                ", so that all of it has room";
      return text + ".";
    }
  } // namespace



  OilInGap
  oil_in_gap(const LubricationParameters &lubrication,
             const double                 initial_gap,
             const double                 touch_gap)
  {
    OilInGap oil;
    oil.initial_gap = initial_gap;
    if (lubrication.model == LubricantModel::none)
      return oil;
    const double start_gap = touch_gap + initial_gap;
    switch (lubrication.amount)
      {
        case OilAmount::void_at_start:
          oil.thickness = lubrication.wetting * start_gap;
          break;
        case OilAmount::void_at_touch:
          if (!(touch_gap > tolerance * start_gap))
            throw InputError(
              "Lubrication/Oil amount: found part of void at touch, but "
              "surfaces that fit into each other have no void when they touch; "
              "expected film thickness.");
          oil.thickness = lubrication.wetting * touch_gap;
          break;
        case OilAmount::film_thickness:
          oil.thickness = lubrication.film;
          break;
      }
    oil.part_at_touch = oil.thickness / touch_gap;
    oil.initial_gap   = std::max(initial_gap, oil.thickness - touch_gap);
    oil.part_at_start = lubrication.wetting;
    if (lubrication.amount != OilAmount::void_at_start)
      {
        oil.film          = oil.thickness;
        oil.part_at_start = oil.initial_gap > initial_gap ?
                              1. :
                              oil.thickness / (touch_gap + oil.initial_gap);
      }
    oil.warning = warning_of_flood(lubrication, initial_gap, touch_gap, oil);
    return oil;
  }
} // namespace asperity
