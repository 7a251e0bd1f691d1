#pragma once

namespace gouge {

/// The numbers of CUTTER/d,r,e,f,alpha,beta,h. The bottom line runs from the tip at angle alpha to the tip plane,
/// rising, or falling for a hollow bottom. The side leans outward or inward by beta from the axis. The diameter at
/// which these two lines meet is d. The corner arc of radius r touches both; e and f place its centre. They follow from
/// d, r, alpha and beta, and programs that write them disagree about them.
struct AptCutter {
  double d_mm = 0, r_mm = 0, e_mm = 0, f_mm = 0;
  double alpha_deg = 0, beta_deg = 0;
  double h_mm = 0;
};

}  // namespace gouge
