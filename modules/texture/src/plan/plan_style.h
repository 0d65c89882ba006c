#pragma once

#include "plan/plan_drawing.h"

namespace pcl::acmap {

inline constexpr PlanColor wall_color{52, 52, 52}, half_wall_color{150, 150, 150},
    room_color{250, 248, 243}, floor_color{240, 235, 223},
    furniture_color{251, 251, 251}, furniture_ink{140, 140, 140},
    window_ink{40, 100, 165};

inline constexpr PlanPen face_pen{0.25, ink}, unseen_pen{0.2, {150, 90, 40}, true},
    leaf_pen{0.4, ink}, swing_pen{0.13, {110, 110, 110}}, window_pen{0.18, window_ink},
    furniture_pen{0.13, furniture_ink}, passage_pen{0.13, {110, 110, 110}, true};

} // namespace pcl::acmap
