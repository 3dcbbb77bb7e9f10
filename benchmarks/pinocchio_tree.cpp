// Pinocchio's articulated-body algorithm for benchmarks/rhs_pinocchio.py: a loop of calls, and its CasADi expression.
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

pinocchio::Model tree(int n, const double *bodies, const double *gravity) {
  pinocchio::Model model;
  model.gravity.linear() = Eigen::Vector3d(gravity[0], gravity[1], gravity[2]);
  for (int k = 0; k < n; ++k) {
    const double *b = bodies + PER_BODY * k;
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> turn(b + 4);
    const pinocchio::SE3 placement(turn, Eigen::Vector3d(b[1], b[2], b[3]));
    const auto joint = model.addJoint(static_cast<pinocchio::JointIndex>(b[0]), pinocchio::JointModelRZ(), placement,
                                      "hinge" + std::to_string(k + 1));
    const pinocchio::Symmetric3 inertia(b[17], b[18], b[19], b[20], b[21], b[22]);
    model.appendBodyToJoint(joint, pinocchio::Inertia(b[13], Eigen::Vector3d(b[14], b[15], b[16]), inertia),
                            pinocchio::SE3::Identity());
  }
  return model;
}

}  // namespace

extern "C" {

// z: angles, rates, accelerations (n each); the last call's accelerations stay in it
void aba_loop(int n, const double *bodies, const double *gravity, double *z, long long calls) {
  const pinocchio::Model model = tree(n, bodies, gravity);
  pinocchio::Data data(model);
  Eigen::Map<Eigen::VectorXd> q(z, n), v(z + n, n), a(z + 2 * n, n);
  Eigen::VectorXd angles = q, rates = v, torque = Eigen::VectorXd::Zero(n);
  for (long long k = 0; k < calls; ++k) {
    pinocchio::aba(model, data, angles, rates, torque, pinocchio::Convention::LOCAL);
    angles += DRIFT * rates;
    rates += DRIFT * data.ddq;
  }
  a = data.ddq;
}

// writes the serialised CasADi Function (angles, rates) -> accelerations to a file
void aba_expression(int n, const double *bodies, const double *gravity, const char *path) {
  using SX = casadi::SX;
  using Vector = Eigen::Matrix<SX, Eigen::Dynamic, 1>;
  const pinocchio::ModelTpl<SX> model = tree(n, bodies, gravity).cast<SX>();
  pinocchio::DataTpl<SX> data(model);
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
