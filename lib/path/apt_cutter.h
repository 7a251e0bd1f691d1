#pragma once

namespace gouge {

/// CUTTER/d,r,e,f,alpha,beta,h. The bottom line runs from the tip at alpha against the tip plane, rising, or falling
/// for a hollow bottom. The side leans outward by beta from the axis, or inward. The diameter at which these two lines
/// meet is d. The corner arc of radius r touches both; e and f place its centre. They follow from d, r, alpha and beta,
/// and writers disagree about them.
struct AptCutter {
  double d_mm = 0, r_mm = 0, e_mm = 0, f_mm = 0;
  double alpha_deg = 0, beta_deg = 0;
  double h_mm = 0;
};

}  // namespace gouge
