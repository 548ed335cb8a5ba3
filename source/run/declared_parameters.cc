#include <sandglass/run/declared_parameters.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    using Tree = boost::property_tree::ptree;

    void
    add_parameters(const std::string              &section,
                   const Tree                     &tree,
                   std::vector<DeclaredParameter> &parameters)
    {
      for (const auto &[name, child] : tree)
        if (child.count("default_value") == 0)
          add_parameters(section.empty() ? name : section + '/' + name,
                         child,
                         parameters);
        else
          parameters.push_back({section,
                                name,
                                child.get<std::string>("value"),
                                child.get<std::string>("default_value"),
                                child.get<std::string>("pattern_description"),
                                child.get<std::string>("documentation")});
    }
  } // namespace



  std::vector<DeclaredParameter>
  declared_parameters(const ParameterHandler &prm)
  {
    // The only way to all entries that the handler offers.
    std::stringstream json;
    prm.print_parameters(json,
                         ParameterHandler::JSON |
                           ParameterHandler::KeepDeclarationOrder);
    Tree tree;
    boost::property_tree::read_json(json, tree);
    std::vector<DeclaredParameter> parameters;
    add_parameters("", tree, parameters);
    return parameters;
  }
} // namespace Sandglass
