// Pinocchio's articulated-body algorithm for benchmarks/cases/rhs_pinocchio.py: a loop of calls, and its CasADi expression.
//
// bodies: 23 numbers a body: parent (0 is the ground), placement of the hinge in the parent (3 translation, 9 rotation
// row by row), mass, centre of mass (3), inertia about it (xx, xy, yy, xz, yz, zz). The hinge turns about its z-axis.

#include <pinocchio/autodiff/casadi.hpp>

#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>

#include <fstream>
#include <string>

namespace {

constexpr int PER_BODY = 23;
constexpr double DRIFT = 1e-15;  // s: without it the compiler may take the work out of the loop

// Hinges alone: with all of Pinocchio's joint types the compiler takes ten times as long, for the same code
template <typename Scalar, int Options>
struct Hinges {
  using JointModelRZ = pinocchio::JointModelRevoluteTpl<Scalar, Options, 2>;
  using JointDataRZ = pinocchio::JointDataRevoluteTpl<Scalar, Options, 2>;
  using JointModelVariant = boost::variant<JointModelRZ>;
  using JointDataVariant = boost::variant<JointDataRZ>;
};
template <typename Scalar>
using Model = pinocchio::ModelTpl<Scalar, 0, Hinges>;
template <typename Scalar>
using Data = pinocchio::DataTpl<Scalar, 0, Hinges>;

Model<double> tree(int n, const double *bodies, const double *gravity) {
  Model<double> model;
  model.gravity.linear() = Eigen::Vector3d(gravity[0], gravity[1], gravity[2]);
  for (int k = 0; k < n; ++k) {
    const double *b = bodies + PER_BODY * k;
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> turn(b + 4);
    const pinocchio::SE3 placement(turn, Eigen::Vector3d(b[1], b[2], b[3]));
    const auto joint = model.addJoint(static_cast<pinocchio::JointIndex>(b[0]), Hinges<double, 0>::JointModelRZ(), placement,
                                      "hinge" + std::to_string(k + 1));
    const pinocchio::Symmetric3 inertia(b[17], b[18], b[19], b[20], b[21], b[22]);
    model.appendBodyToJoint(joint, pinocchio::Inertia(b[13], Eigen::Vector3d(b[14], b[15], b[16]), inertia),
                            pinocchio::SE3::Identity());
  }
  return model;
}

struct Tree {
  explicit Tree(const Model<double> &given) : model(given), data(model) {}
  Model<double> model;
  Data<double> data;
};

}  // namespace

extern "C" {

void *tree_new(int n, const double *bodies, const double *gravity) { return new Tree(tree(n, bodies, gravity)); }

void tree_delete(void *tree) { delete static_cast<Tree *>(tree); }

// z: angles, rates, accelerations (n each); the last call's accelerations stay in it
void aba_loop(void *tree, double *z, long long calls) {
  auto &[model, data] = *static_cast<Tree *>(tree);
  const Eigen::Index n = model.nv;
  const Eigen::VectorXd torque = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd angles = Eigen::Map<Eigen::VectorXd>(z, n), rates = Eigen::Map<Eigen::VectorXd>(z + n, n);
  for (long long k = 0; k < calls; ++k) {
    pinocchio::aba(model, data, angles, rates, torque, pinocchio::Convention::LOCAL);
    angles += DRIFT * rates;
    rates += DRIFT * data.ddq;
  }
  Eigen::Map<Eigen::VectorXd>(z + 2 * n, n) = data.ddq;
}

// writes the serialised CasADi Function (angles, rates) -> accelerations to a file
void aba_expression(int n, const double *bodies, const double *gravity, const char *path) {
  using SX = casadi::SX;
  using Vector = Eigen::Matrix<SX, Eigen::Dynamic, 1>;
  const Model<SX> model = tree(n, bodies, gravity).cast<SX>();
  Data<SX> data(model);
  const SX angles = SX::sym("q", n), rates = SX::sym("v", n);
  Vector q(n), v(n), torque = Vector::Zero(n);
  for (int k = 0; k < n; ++k) {
    q[k] = angles(k);
    v[k] = rates(k);
  }
  pinocchio::aba(model, data, q, v, torque, pinocchio::Convention::LOCAL);
  SX found(n, 1);
  for (int k = 0; k < n; ++k) found(k) = data.ddq[k];
  std::ofstream(path) << casadi::Function("aba", {angles, rates}, {found}).serialize();
}
}
