#include "drivers/problem/study_model.hpp"

#include "drivers/problem/adapt_setup.hpp"
#include "drivers/problem/plate_setup.hpp"
#include "drivers/problem/scalar_setup.hpp"
#include "drivers/problem/solved.hpp"
#include "drivers/problem/watched_lines.hpp"

namespace anisofront {
namespace {

ModelRequests requests_of(const Study& study, const Domain& domain) {
  ModelRequests requests{study_goal(study, domain), {}};
  for (const ValueRequest& value : study.output.values)
    requests.points.push_back({value.name, value.at});
  return requests;
}

Model plate_model_of(const Study& study, const Domain& domain, PlateElement element,
                     ModelRequests requests, const Monitor& monitor) {
  PlateOptions options;
  options.element = element;
  options.threads = study.solver.threads;
  options.linear = linear_options(study.solver);
  return plate_model(plate_problem(*study.plate, domain, monitor), options, std::move(requests));
}

Model scalar_model_of(const Study& study, const Domain& domain, ModelRequests requests) {
  ScalarOptions options;
  options.order = study.problem->order;
  options.threads = study.solver.threads;
  options.linear = linear_options(study.solver);
  const auto exact = known_solution(*study.problem);
  return scalar_model(scalar_problem(*study.problem, domain, exact), exact, options,
                      std::move(requests));
}

/// What the solver says about the problem gets the line of the problem.
Model with_place(Model model, std::string file, std::string place) {
  return [=](const FeMesh& mesh, const Monitor& monitor) {
    try {
      return model(mesh, monitor);
    } catch (const InputError& error) {
      const std::string message = error.what();
      if (message.starts_with(file)) throw;
      throw InputError(place + ": " + message);
    }
  };
}

Model model_of(const Study& study, const Domain& domain, ModelRequests requests,
               const Monitor& monitor) {
  Model model = study.plate ? plate_model_of(study, domain, study.plate->element,
                                             std::move(requests), monitor)
                            : scalar_model_of(study, domain, std::move(requests));
  return with_place(std::move(model), study.file.string(),
                    study.plate ? study.plate->place : study.problem->place);
}

}  // namespace

Model study_model(const Study& study, const Domain& domain, const Monitor& monitor) {
  return with_profiles(model_of(study, domain, requests_of(study, domain), monitor),
                       watched_lines(study, domain));
}

Model reference_model(const Study& study, const Domain& domain) {
  Model model = model_of(study, domain, {}, {});
  if (!study.plate || study.plate->element != PlateElement::mitc4) return model;
  return [=, on_triangles = plate_model_of(study, domain, PlateElement::mitc, {}, {})](
             const FeMesh& mesh, const Monitor& monitor) {
    return mesh.mesh.quads.empty() ? on_triangles(mesh, monitor) : model(mesh, monitor);
  };
}

}  // namespace anisofront
