// SPDX-License-Identifier: Apache-2.0
#include "verbs/references.hpp"

#include "ionskin/laws/coupling/coupling_law.hpp"

#include <fmt/format.h>

#include <array>

namespace ionskin::apps {
namespace {

bool has_contact(const Case& input) {
  return input.strain.kind == StrainSourceKind::contact;
}

bool has_soft_slider(const Case& input) {
  return has_contact(input) && !input.slider.rigid();
}

bool adheres(const Case& input) {
  return has_contact(input) && input.contact.law == "adhesive";
}

bool slips_viscously(const Case& input) {
  return has_contact(input) && input.contact.law == "viscous";
}

bool resolves_ions(const Case& input) {
  return input.electrochemistry.ion_model != IonModel::thin_layers;
}

bool has_lattice_ions(const Case& input) {
  return input.electrochemistry.ion_model == IonModel::steric;
}

bool has_moving_water(const Case& input) {
  return laws::coupling_law(input.coupling.law).traits.moves_water;
}

bool always(const Case&) {
  return true;
}

constexpr std::array<Reference, 17> table{{
    {"small1984", "finite layers", "article", "J. C. Small and J. R. Booker",
     "Finite layer analysis of layered elastic materials using a flexibility approach. Part 1---"
     "Strip loadings",
     "journal = {International Journal for Numerical Methods in Engineering}, volume = {20}, "
     "number = {6}, pages = {1025--1037}",
     1984, "10.1002/nme.1620200606", has_contact, "author, volume, pages and doi"},
    {"kausel1981", "stiffness of a layer", "article",
     "Eduardo Kausel and Jos{\\'e} Manuel Ro{\\\"e}sset", "Stiffness matrices for layered soils",
     "journal = {Bulletin of the Seismological Society of America}, volume = {71}, number = {6}, "
     "pages = {1743--1761}",
     1981, "10.1785/BSSA0710061743", has_contact, "doi"},
    {"buzbee1971", "free sides and ends of the skin", "article",
     "B. L. Buzbee and F. W. Dorr and J. A. George and G. H. Golub",
     "The Direct Solution of the Discrete {Poisson} Equation on Irregular Regions",
     "journal = {SIAM Journal on Numerical Analysis}, volume = {8}, number = {4}, "
     "pages = {722--736}",
     1971, "10.1137/0708066", has_contact},
    {"simo1992", "friction by return mapping", "article", "J. C. Simo and T. A. Laursen",
     "An augmented {Lagrangian} treatment of contact problems involving friction",
     "journal = {Computers \\& Structures}, volume = {42}, number = {1}, pages = {97--116}", 1992,
     "10.1016/0045-7949(92)90540-G", has_contact},
    {"johnson1985", "the soft slider", "book", "K. L. Johnson", "Contact Mechanics",
     "publisher = {Cambridge University Press}", 1985, "10.1017/CBO9781139171731", has_soft_slider},
    {"love1929", "the soft slider", "article", "A. E. H. Love",
     "The stress produced in a semi-infinite solid by pressure on part of the boundary",
     "journal = {Philosophical Transactions of the Royal Society of London. Series A}, "
     "volume = {228}, pages = {377--420}",
     1929, "10.1098/rsta.1929.0009", has_soft_slider},
    {"maugis1992", "adhesion", "article", "Daniel Maugis",
     "Adhesion of spheres: The {JKR}-{DMT} transition using a {Dugdale} model",
     "journal = {Journal of Colloid and Interface Science}, volume = {150}, number = {1}, "
     "pages = {243--269}",
     1992, "10.1016/0021-9797(92)90285-T", adheres},
    {"johnson1971", "adhesion", "article", "K. L. Johnson and K. Kendall and A. D. Roberts",
     "Surface energy and the contact of elastic solids",
     "journal = {Proceedings of the Royal Society of London. Series A}, volume = {324}, "
     "number = {1558}, pages = {301--313}",
     1971, "10.1098/rspa.1971.0141", adheres},
    {"hillerborg1976", "the cohesive zone of adhesion", "article",
     "A. Hillerborg and M. Mod{\\'e}er and P.-E. Petersson",
     "Analysis of crack formation and crack growth in concrete by means of fracture mechanics and "
     "finite elements",
     "journal = {Cement and Concrete Research}, volume = {6}, number = {6}, pages = {773--781}",
     1976, "10.1016/0008-8846(76)90007-7", adheres},
    {"olsson1998", "friction that depends on the speed of slip", "article",
     "H. Olsson and K. J. {\\AA}str{\\\"o}m and C. {Canudas de Wit} and M. G{\\\"a}fvert and P. "
     "Lischinsky",
     "Friction Models and Friction Compensation",
     "journal = {European Journal of Control}, volume = {4}, number = {3}, pages = {176--195}",
     1998, "10.1016/S0947-3580(98)70113-X", slips_viscously},
    {"scharfetter1969", "fluxes of the ions", "article", "D. L. Scharfetter and H. K. Gummel",
     "Large-signal analysis of a silicon {Read} diode oscillator",
     "journal = {IEEE Transactions on Electron Devices}, volume = {16}, number = {1}, "
     "pages = {64--77}",
     1969, "10.1109/T-ED.1969.16566", resolves_ions},
    {"saad1986", "linear systems of the ion transport", "article",
     "Youcef Saad and Martin H. Schultz",
     "{GMRES}: A Generalized Minimal Residual Algorithm for Solving Nonsymmetric Linear Systems",
     "journal = {SIAM Journal on Scientific and Statistical Computing}, volume = {7}, "
     "number = {3}, pages = {856--869}",
     1986, "10.1137/0907058", resolves_ions},
    {"curtiss1952", "integration in time", "article", "C. F. Curtiss and J. O. Hirschfelder",
     "Integration of Stiff Equations",
     "journal = {Proceedings of the National Academy of Sciences}, volume = {38}, number = {3}, "
     "pages = {235--243}",
     1952, "10.1073/pnas.38.3.235", resolves_ions},
    {"bikerman1942", "ions that take room", "article", "J. J. Bikerman",
     "Structure and capacity of electrical double layer",
     "journal = {The London, Edinburgh, and Dublin Philosophical Magazine and Journal of "
     "Science}, volume = {33}, number = {220}, pages = {384--397}",
     1942, "10.1080/14786444208520813", has_lattice_ions, "title, number and doi"},
    {"biot1941", "pressure and flow of the water", "article", "Maurice A. Biot",
     "General Theory of Three-Dimensional Consolidation",
     "journal = {Journal of Applied Physics}, volume = {12}, number = {2}, pages = {155--164}",
     1941, "10.1063/1.1712886", has_moving_water},
    {"ramo1939", "charge of the electrodes", "article", "Simon Ramo",
     "Currents Induced by Electron Motion",
     "journal = {Proceedings of the IRE}, volume = {27}, number = {9}, pages = {584--585}", 1939,
     "10.1109/JRPROC.1939.228757", always},
    {"tiesinga2021", "constants", "article",
     "Eite Tiesinga and Peter J. Mohr and David B. Newell and Barry N. Taylor",
     "{CODATA} recommended values of the fundamental physical constants: 2018",
     "journal = {Reviews of Modern Physics}, volume = {93}, number = {2}, pages = {025010}", 2021,
     "10.1103/RevModPhys.93.025010", always},
}};

} // namespace

std::span<const Reference> references() {
  return table;
}

std::string bibtex(const Reference& one) {
  const std::string check =
      one.unconfirmed.empty()
          ? std::string()
          : fmt::format("% Not confirmed by a second source, check it: {}.\n", one.unconfirmed);
  return fmt::format("% {}\n{}@{}{{{},\n  author = {{{}}},\n  title = {{{}}},\n  {},\n"
                     "  year = {{{}}},\n  doi = {{{}}},\n  url = {{https://doi.org/{}}}\n}}\n",
                     one.purpose, check, one.type, one.key, one.author, one.title, one.place,
                     one.year, one.doi, one.doi);
}

} // namespace ionskin::apps
