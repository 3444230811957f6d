// A model as results list it: plain values that outlive it.
#pragma once

#include <string>
#include <vector>

namespace moat {

class Model;

struct NodeFacts {
  std::string name;
  double mass = 0.0;    ///< kg
  double x = 0.0;       ///< m, of drawings
  double height = 0.0;  ///< m, of drawings
};

struct ParameterFacts {
  std::string name;  ///< as scripts write it: "stiffness"
  double value = 0.0;
  std::string unit;  ///< SI symbol
};

struct ElementFacts {
  std::string name;
  std::string law;            ///< name of the law; empty where it is not known
  std::string first, second;  ///< names of the nodes it joins; "ground" for the ground
  std::vector<ParameterFacts> parameters;
};

struct ModelFacts {
  std::vector<NodeFacts> nodes;
  std::vector<ElementFacts> elements;
};

/// All nodes and elements of a model with their parameters.
ModelFacts facts_of(const Model& model);

}  // namespace moat
