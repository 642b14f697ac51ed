#ifndef asperity_tests_contact_sheared_h
#define asperity_tests_contact_sheared_h

#include <asperity/contact/contact_assembler.h>

#include <vector>

// What the tests of contacts that bear shear have in common.
namespace example
{
  struct Interface
  {
    asperity::ContactFormulation formulation;
    asperity::InterfaceShear     law;
  };



  inline asperity::ContactOptions
  contact_options(const Interface &interface, const double penalty)
  {
    asperity::ContactOptions options;
    options.formulation                    = interface.formulation;
    options.penalty                        = penalty;
    options.interface.stick_penalty        = 1.;
    options.interface.law                  = interface.law;
    options.interface.friction_coefficient = 0.3;
    options.interface.shear_factor         = 0.5;
    return options;
  }



  /** A shear strength k [Pa] that is the same everywhere, of a dry interface.
   */
  template <int dim>
  void
  set_strength(asperity::ContactAssembler<dim> &contact, const double k)
  {
    const std::size_t n = contact.pressure().size();
    if (contact.shear() != nullptr)
      contact.shear()->set_interface(std::vector<double>(n, k),
                                     std::vector<double>(n, 0.));
  }
} // namespace example

#endif
