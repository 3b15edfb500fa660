#version 300 es

precision highp float;
precision highp int;

struct BarchanTable {
    vec2 extent;
    vec2 spacing;
    float scale;
    float bias;
    uint transfer;
    uint edges;
    float first_azimuth;
    float azimuth_step;
    uint azimuths;
    uint is_circle;
    uint candidates;
    uint rings;
    uint ring_spacing;
    uint depth_mode;
    float max_tangent;
    float max_polar;
    float relief_top;
    float relief_thickness;
    uint first_level;
    uint levels;
    float least;
    float greatest;
};
struct BarchanReliefRay {
    vec2 place;
    vec2 step_;
    vec3 towards;
    float tangent;
    bool is_valid;
};
struct BarchanStart {
    float depth;
    bool is_proven;
    ivec2 fetches;
};
struct BarchanFound {
    float depth;
    ivec2 fetches;
};
struct BarchanReliefExit {
    float depth;
    ivec2 next;
};
struct BarchanReliefLeft {
    float outside;
    float inside;
    bool is_within;
    int fetches;
};
struct BarchanMipBlock {
    ivec2 low;
    ivec2 high;
    ivec2 texel;
};
struct BarchanProbe {
    vec2 place;
    vec2 step_;
    vec3 light;
    float angular_radius;
    vec3 eye;
    float level_distance;
    vec3 first_form;
    float tolerance;
    vec3 second_form;
    float unused_0_;
    vec3 along_u;
    float unused_1_;
    vec3 along_v;
    float unused_2_;
};
const uint BARCHAN_HEIGHT = 0u;
const uint BARCHAN_HEMISPHERE = 8u;
const uint BARCHAN_MAXIMUM_MIP = 11u;
const float BARCHAN_LONGEST_WAY = 65536.0;
const float BARCHAN_FARTHEST = 16777216.0;
const float BARCHAN_STEEPEST = 1048576.0;
const int BARCHAN_MOST_TURNS = 4096;
const float BARCHAN_STEP_BACK = 0.015625;
const float BARCHAN_TAU = 6.2831855;
const int BARCHAN_ENDLESS = 33554432;
const float BARCHAN_LONGEST_BLOCK = 4.0;


float barchan_arcsine(float sine) {
    float size_1 = min(abs(sine), 1.0);
    bool is_steep = (size_1 > 0.5);
    float square = (is_steep ? (0.5 * (1.0 - size_1)) : (size_1 * size_1));
    float root = (is_steep ? sqrt(square) : size_1);
    float series = (((((((((((0.0421632 * square) + 0.024181312) * square) + 0.045470025) * square) + 0.074953005) * square) + 0.16666752) * square) * root) + root);
    float angle_1 = (is_steep ? (1.5707963 - (2.0 * series)) : series);
    return ((sine < 0.0) ? -(angle_1) : angle_1);
}

float barchan_arctangent(float tangent) {
    float start = 0.0;
    float part = 0.0;
    float size_2 = abs(tangent);
    part = size_2;
    if ((size_2 > 2.4142137)) {
        start = 1.5707964;
        part = (-1.0 / size_2);
    } else {
        if ((size_2 > 0.41421357)) {
            start = 0.7853982;
            part = ((size_2 - 1.0) / (size_2 + 1.0));
        }
    }
    float _e18 = part;
    float _e19 = part;
    float square_1 = (_e18 * _e19);
    float _e21 = start;
    float _e33 = part;
    float _e35 = part;
    float angle_2 = (_e21 + (((((((((0.080537446 * square_1) - 0.13877685) * square_1) + 0.19977711) * square_1) - 0.3333295) * square_1) * _e33) + _e35));
    return ((tangent < 0.0) ? -(angle_2) : angle_2);
}

float barchan_azimuth(vec2 direction) {
    vec2 size_3 = abs(direction);
    float larger = max(size_3.x, size_3.y);
    if (!((larger > 0.0))) {
        return 0.0;
    }
    float sine_1 = (min(size_3.x, size_3.y) / larger);
    float _e13 = barchan_arctangent(sine_1);
    float quadrant = ((size_3.y > size_3.x) ? (1.5707964 - _e13) : _e13);
    float half_ = ((direction.x < 0.0) ? (3.1415927 - quadrant) : quadrant);
    return ((direction.y < 0.0) ? -(half_) : half_);
}

vec2 barchan_sine_cosine(float angle) {
    bool local = false;
    float quarter = roundEven((angle * 0.63661975));
    float rest = (((angle - (quarter * 1.5703125)) - (quarter * 0.0004837513)) - (quarter * 7.54979e-8));
    float square_2 = (rest * rest);
    float sine_2 = (((((((-0.00019515296 * square_2) + 0.008332161) * square_2) - 0.16666655) * square_2) * rest) + rest);
    float cosine = ((((((((2.4433157e-5 * square_2) - 0.0013887316) * square_2) + 0.041666646) * square_2) * square_2) - (0.5 * square_2)) + 1.0);
    int turned = (int(quarter) & 3);
    vec2 swapped = (((turned & 1) != 0) ? vec2(cosine, sine_2) : vec2(sine_2, cosine));
    if (!((turned == 1))) {
        local = (turned == 2);
    } else {
        local = true;
    }
    bool _e65 = local;
    return vec2(((turned >= 2) ? -(swapped.x) : swapped.x), (_e65 ? -(swapped.y) : swapped.y));
}

ivec2 barchan_chosen(ivec2 other, ivec2 chosen, bvec2 is_chosen) {
    return ivec2((is_chosen.x ? chosen.x : other.x), (is_chosen.y ? chosen.y : other.y));
}

vec2 barchan_transferred_2_(uint table_6, vec2 number_1) {
    return number_1;
}

vec4 barchan_transferred_4_(uint table_7, vec4 number_2) {
    return number_2;
}

vec2 barchan_relief_at(BarchanReliefRay ray, float depth_1) {
    return (ray.place + (depth_1 * ray.step_));
}

float barchan_relief_way(BarchanReliefRay ray_1) {
    return max(abs(ray_1.step_.x), abs(ray_1.step_.y));
}

float barchan_relief_way_ahead(BarchanReliefRay ray_2, float start_1) {
    float _e7 = barchan_relief_way(ray_2);
    return (((start_1 > 0.0) ? 0.03125 : 0.25) * _e7);
}

ivec2 barchan_relief_cell(BarchanReliefRay ray_3, float depth_2) {
    vec2 _e2 = barchan_relief_at(ray_3, depth_2);
    return ivec2(mix(floor(_e2), (ceil(_e2) - vec2(1.0)), lessThan(ray_3.step_, vec2(0.0))));
}

ivec2 barchan_relief_cell_of(BarchanReliefRay ray_4, ivec2 low, ivec2 high, float depth_3) {
    ivec2 _e4 = barchan_relief_cell(ray_4, depth_3);
    return min(max(_e4, low), (high - ivec2(1)));
}

BarchanReliefExit barchan_relief_exit(BarchanReliefRay ray_5, ivec2 low_1, ivec2 high_1, float start_2) {
    ivec2 next = ivec2(0);
    bvec2 moves = notEqual(ray_5.step_, vec2(0.0));
    ivec2 _e12 = barchan_chosen(low_1, high_1, greaterThan(ray_5.step_, vec2(0.0)));
    vec2 ends = vec2(_e12);
    vec2 borders = mix(vec2(1e30), ((ends - ray_5.place) / mix(vec2(1.0), ray_5.step_, moves)), moves);
    float depth_8 = min(max(min(borders.x, borders.y), start_2), 1.0);
    ivec2 _e30 = barchan_relief_cell_of(ray_5, low_1, high_1, depth_8);
    next = _e30;
    ivec2 _e39 = barchan_chosen(high_1, (low_1 - ivec2(1)), lessThan(ray_5.step_, vec2(0.0)));
    if ((borders.x <= borders.y)) {
        next.x = _e39.x;
    } else {
        next.y = _e39.y;
    }
    ivec2 _e47 = next;
    return BarchanReliefExit(depth_8, _e47);
}

float barchan_relief_twist(vec4 corners) {
    return ((corners.x - corners.y) + (corners.w - corners.z));
}

float barchan_relief_cell_gap(BarchanReliefRay ray_6, ivec2 cell_1, vec4 corners_1, float depth_4) {
    vec2 place_12 = ((ray_6.place - vec2(cell_1)) + (depth_4 * ray_6.step_));
    float plane = ((corners_1.x + ((corners_1.y - corners_1.x) * place_12.x)) + ((corners_1.z - corners_1.x) * place_12.y));
    float _e23 = barchan_relief_twist(corners_1);
    return ((plane + ((_e23 * place_12.x) * place_12.y)) - depth_4);
}

float barchan_relief_first_zero(float g0_, float g1_, float c) {
    bool local_4 = false;
    bool local_5 = false;
    bool local_6 = false;
    float s = 1.0;
    bool local_7 = false;
    if ((g0_ <= 0.0)) {
        return 0.0;
    }
    float b = ((g1_ - g0_) - c);
    float discriminant = ((b * b) - ((4.0 * c) * g0_));
    if ((g1_ > 0.0)) {
        if (!((c <= 0.0))) {
            local_5 = (b >= 0.0);
        } else {
            local_5 = true;
        }
        bool _e25 = local_5;
        if (!(_e25)) {
            local_6 = (discriminant < 0.0);
        } else {
            local_6 = true;
        }
        bool _e32 = local_6;
        local_4 = _e32;
    } else {
        local_4 = false;
    }
    bool _e34 = local_4;
    if (_e34) {
        return -1.0;
    }
    float root_1 = sqrt(max(discriminant, 0.0));
    if ((b <= 0.0)) {
        s = ((2.0 * g0_) / (root_1 - b));
    } else {
        s = ((root_1 + b) / (-2.0 * c));
    }
    if ((g1_ > 0.0)) {
        float _e55 = s;
        local_7 = (_e55 > 1.0);
    } else {
        local_7 = false;
    }
    bool _e59 = local_7;
    if (_e59) {
        return -1.0;
    }
    float _e61 = s;
    return min(_e61, 1.0);
}

float barchan_relief_hit(BarchanReliefRay ray_8, ivec2 cell_2, vec4 corners_2, float start_3, float end) {
    float part_2 = (end - start_3);
    float _e6 = barchan_relief_twist(corners_2);
    float twist = ((_e6 * (part_2 * ray_8.step_.x)) * (part_2 * ray_8.step_.y));
    float _e15 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, start_3);
    float _e16 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, end);
    float _e17 = barchan_relief_first_zero(_e15, _e16, twist);
    return ((_e17 < 0.0) ? -1.0 : (start_3 + (_e17 * part_2)));
}

ivec3 barchan_mip_range(bool repeats, int cell_3, int size, int level_2) {
    bool local_15 = false;
    bool local_16 = false;
    int last = (max((size >> uint(level_2)), 1) - 1);
    int repeated = (((cell_3 % size) + size) % size);
    int inside_1 = (repeats ? repeated : min(max(cell_3, 0), (size - 1)));
    int tile = (repeats ? (cell_3 - inside_1) : 0);
    int texel = min((inside_1 >> uint(level_2)), last);
    int low_2 = (texel << uint(level_2));
    int high_2 = ((texel == last) ? size : ((texel + 1) << uint(level_2)));
    if (repeats) {
        return ivec3((tile + low_2), (tile + high_2), texel);
    }
    if ((level_2 == 0)) {
        local_15 = (cell_3 < 0);
    } else {
        local_15 = false;
    }
    bool _e42 = local_15;
    if (_e42) {
        return ivec3(-33554432, 0, texel);
    }
    if ((level_2 > 0)) {
        local_16 = (texel == 0);
    } else {
        local_16 = false;
    }
    bool _e54 = local_16;
    return ivec3((_e54 ? -33554432 : low_2), ((texel == last) ? BARCHAN_ENDLESS : high_2), texel);
}

void main() {
    uint index = uint(gl_VertexID);
    gl_Position = vec4(((float((index & 1u)) * 4.0) - 1.0), ((float((index >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
    gl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);
    return;
}

