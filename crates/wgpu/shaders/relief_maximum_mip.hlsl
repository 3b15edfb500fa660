struct BarchanTable {
    float2 extent;
    float2 spacing;
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

struct BarchanTangentLight {
    float height;
    float level;
    float2 direction;
    float azimuth;
    float stretch;
};

struct BarchanGradients {
    float3 of_u;
    int _pad1_0;
    float3 of_v;
    int _end_pad_0;
};

struct BarchanReliefRay {
    float2 place;
    float2 step_;
    float3 towards;
    float tangent;
    bool is_valid;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct BarchanStart {
    float depth;
    bool is_proven;
    int2 fetches;
};

struct BarchanFound {
    float depth;
    int _pad1_0;
    int2 fetches;
};

struct BarchanReliefExit {
    float depth;
    int _pad1_0;
    int2 next;
};

struct BarchanReliefLeft {
    float outside;
    float inside;
    bool is_within;
    int fetches;
};

struct BarchanMipBlock {
    int2 low;
    int2 high;
    int2 texel;
};

struct BarchanProbe {
    float2 place;
    float2 step_;
    float3 light;
    float angular_radius;
    float3 eye;
    float level_distance;
    float3 first_form;
    float tolerance;
    float3 second_form;
    float unused_0_;
    float3 along_u;
    float unused_1_;
    float3 along_v;
    float unused_2_;
};

static const uint BARCHAN_HEIGHT = 0u;
static const uint BARCHAN_MAXIMUM_MIP = 11u;
static const float BARCHAN_LONGEST_WAY = 65536.0;
static const float BARCHAN_FARTHEST = 16777216.0;
static const float BARCHAN_STEEPEST = 1048576.0;
static const int BARCHAN_MOST_TURNS = int(4096);
static const float BARCHAN_STEP_BACK = 0.015625;
static const int BARCHAN_ENDLESS = int(33554432);
static const float BARCHAN_LONGEST_BLOCK = 4.0;

cbuffer barchan_tables : register(b0) { BarchanTable barchan_tables[12]; }
Texture2D<float4> barchan_height_texels : register(t2);
Texture2D<float4> barchan_maximum_mip_texels : register(t13);
cbuffer barchan_probe : register(b14) { BarchanProbe barchan_probe; }

struct FragmentInput_barchan_probe_relief {
    float4 position_3 : SV_Position;
};

struct FragmentInput_barchan_probe_relief_shadow {
    float4 position_4 : SV_Position;
};

float barchan_arcsine(float sine)
{
    float size_1 = min(abs(sine), 1.0);
    bool is_steep = (size_1 > 0.5);
    float square = (is_steep ? (0.5 * (1.0 - size_1)) : (size_1 * size_1));
    float root = (is_steep ? sqrt(square) : size_1);
    float series = (((((((((((0.0421632 * square) + 0.024181312) * square) + 0.045470025) * square) + 0.074953005) * square) + 0.16666752) * square) * root) + root);
    float angle_1 = (is_steep ? (1.5707963 - (2.0 * series)) : series);
    return ((sine < 0.0) ? -(angle_1) : angle_1);
}

float barchan_arctangent(float tangent)
{
    float start = 0.0;
    float part = (float)0;

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

float barchan_azimuth(float2 direction)
{
    float2 size_3 = abs(direction);
    float larger = max(size_3.x, size_3.y);
    if (!((larger > 0.0))) {
        return 0.0;
    }
    float sine_1 = (min(size_3.x, size_3.y) / larger);
    const float _e13 = barchan_arctangent(sine_1);
    float quadrant = ((size_3.y > size_3.x) ? (1.5707964 - _e13) : _e13);
    float half_ = ((direction.x < 0.0) ? (3.1415927 - quadrant) : quadrant);
    return ((direction.y < 0.0) ? -(half_) : half_);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

float2 barchan_sine_cosine(float angle)
{
    bool local = (bool)0;

    float quarter = round((angle * 0.63661975));
    float rest = (((angle - (quarter * 1.5703125)) - (quarter * 0.0004837513)) - (quarter * 7.54979e-8));
    float square_2 = (rest * rest);
    float sine_2 = (((((((-0.00019515296 * square_2) + 0.008332161) * square_2) - 0.16666655) * square_2) * rest) + rest);
    float cosine = ((((((((2.4433157e-5 * square_2) - 0.0013887316) * square_2) + 0.041666646) * square_2) * square_2) - (0.5 * square_2)) + 1.0);
    int turned = (naga_f2i32(quarter) & int(3));
    float2 swapped = (((turned & int(1)) != int(0)) ? float2(cosine, sine_2) : float2(sine_2, cosine));
    if (!((turned == int(1)))) {
        local = (turned == int(2));
    } else {
        local = true;
    }
    bool _e65 = local;
    return float2(((turned >= int(2)) ? -(swapped.x) : swapped.x), (_e65 ? -(swapped.y) : swapped.y));
}

int2 barchan_chosen(int2 other, int2 chosen, bool2 is_chosen)
{
    return int2((is_chosen.x ? chosen.x : other.x), (is_chosen.y ? chosen.y : other.y));
}

int2 naga_mod(int2 lhs, int2 rhs) {
    int2 divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

int2 barchan_inside(uint table, int2 place, int level)
{
    uint first = barchan_tables[table].first_level;
    float2 _e10 = barchan_tables[table].extent;
    int2 whole = naga_f2i32(_e10);
    int2 extent_1 = max((whole >> ((first + uint(level))).xx), (int(1)).xx);
    uint edges = barchan_tables[table].edges;
    int2 repeated = naga_mod(asint(asuint(naga_mod(place, extent_1)) + asuint(extent_1)), extent_1);
    int2 clamped = clamp(place, (int(0)).xx, asint(asuint(extent_1) - asuint((int(1)).xx)));
    const int2 _e41 = barchan_chosen(clamped, repeated, bool2(((edges & 1u) != 0u), ((edges & 2u) != 0u)));
    return _e41;
}

float barchan_scaled(uint table_1, float stored)
{
    float _e5 = barchan_tables[table_1].scale;
    float _e10 = barchan_tables[table_1].bias;
    return ((_e5 * stored) + _e10);
}

float2 barchan_scaled_2_(uint table_2, float2 stored_1)
{
    float _e5 = barchan_tables[table_2].scale;
    float _e10 = barchan_tables[table_2].bias;
    return ((_e5 * stored_1) + (_e10).xx);
}

float4 barchan_scaled_4_(uint table_3, float4 stored_2)
{
    float _e5 = barchan_tables[table_3].scale;
    float _e10 = barchan_tables[table_3].bias;
    return ((_e5 * stored_2) + (_e10).xxxx);
}

float2 barchan_scaled_cone(uint table_4, float2 stored_3)
{
    const float _e4 = barchan_scaled(table_4, stored_3.y);
    return float2(stored_3.x, _e4);
}

float barchan_transferred(uint table_5, float number)
{
    uint _e5 = barchan_tables[table_5].transfer;
    switch(_e5) {
        case 1u: {
            const float _e6 = barchan_arcsine(number);
            return _e6;
        }
        case 2u: {
            return (number * number);
        }
        default: {
            return number;
        }
    }
}

float2 barchan_transferred_2_(uint table_6, float2 number_1)
{
    return number_1;
}

float4 barchan_transferred_4_(uint table_7, float4 number_2)
{
    return number_2;
}

float2 barchan_transferred_cone(uint table_8, float2 number_3)
{
    const float _e4 = barchan_transferred(table_8, number_3.y);
    return float2(number_3.x, _e4);
}

float barchan_height_before_transfer(int2 place_1, int layer)
{
    const int2 _e4 = barchan_inside(BARCHAN_HEIGHT, place_1, int(0));
    float4 _e7 = barchan_height_texels.Load(int3(_e4, layer));
    const float _e9 = barchan_scaled(BARCHAN_HEIGHT, _e7.x);
    return _e9;
}

float barchan_height_texel(int2 place_2, int layer_1)
{
    const float _e3 = barchan_height_before_transfer(place_2, layer_1);
    const float _e4 = barchan_transferred(BARCHAN_HEIGHT, _e3);
    return _e4;
}

float barchan_maximum_mip_before_transfer(int2 place_3, int layer_2)
{
    const int2 _e3 = barchan_inside(BARCHAN_MAXIMUM_MIP, place_3, layer_2);
    float4 _e6 = barchan_maximum_mip_texels.Load(int3(_e3, layer_2));
    const float _e8 = barchan_scaled(BARCHAN_MAXIMUM_MIP, _e6.x);
    return _e8;
}

float barchan_maximum_mip_texel(int2 place_4, int layer_3)
{
    const float _e3 = barchan_maximum_mip_before_transfer(place_4, layer_3);
    const float _e4 = barchan_transferred(BARCHAN_MAXIMUM_MIP, _e3);
    return _e4;
}

BarchanGradients ConstructBarchanGradients(float3 arg0, float3 arg1) {
    BarchanGradients ret = (BarchanGradients)0;
    ret.of_u = arg0;
    ret.of_v = arg1;
    return ret;
}

BarchanGradients barchan_gradients(float3 along_u, float3 along_v)
{
    float3 area = cross(along_u, along_v);
    float area_squared = dot(area, area);
    if (!((area_squared > 0.0))) {
        const BarchanGradients barchangradients = ConstructBarchanGradients((0.0).xxx, (0.0).xxx);
        return barchangradients;
    }
    const BarchanGradients barchangradients_1 = ConstructBarchanGradients((cross(along_v, area) / (area_squared).xxx), (cross(area, along_u) / (area_squared).xxx));
    return barchangradients_1;
}

float2 barchan_texture_step(float3 along_u_1, float3 along_v_1, float3 vector_)
{
    const BarchanGradients _e3 = barchan_gradients(along_u_1, along_v_1);
    return float2(dot(vector_, _e3.of_u), dot(vector_, _e3.of_v));
}

float3 barchan_bump_normal(float3 along_u_2, float3 along_v_2, float3 normal, float2 per_uv)
{
    const BarchanGradients _e4 = barchan_gradients(along_u_2, along_v_2);
    return normalize(((normal - (per_uv.x * _e4.of_u)) - (per_uv.y * _e4.of_v)));
}

BarchanTangentLight ConstructBarchanTangentLight(float arg0, float arg1, float2 arg2, float arg3, float arg4) {
    BarchanTangentLight ret = (BarchanTangentLight)0;
    ret.height = arg0;
    ret.level = arg1;
    ret.direction = arg2;
    ret.azimuth = arg3;
    ret.stretch = arg4;
    return ret;
}

BarchanTangentLight barchan_tangent_light(float3 along_u_3, float3 along_v_3, float3 normal_1, float3 towards, float2 extent)
{
    bool local_1 = (bool)0;

    float height_1 = dot(towards, normal_1);
    float3 tangent_1 = (towards - (normal_1 * height_1));
    float level_6 = length(tangent_1);
    const float2 _e9 = barchan_texture_step(along_u_3, along_v_3, tangent_1);
    float2 on_grid = (_e9 * extent);
    float grid_length = length(on_grid);
    if ((level_6 > 0.0)) {
        local_1 = (grid_length > 0.0);
    } else {
        local_1 = false;
    }
    bool _e19 = local_1;
    if (!(_e19)) {
        const BarchanTangentLight barchantangentlight = ConstructBarchanTangentLight(height_1, level_6, _e9, 0.0, 1.0);
        return barchantangentlight;
    }
    const float _e24 = barchan_azimuth(on_grid);
    const BarchanTangentLight barchantangentlight_1 = ConstructBarchanTangentLight(height_1, level_6, _e9, _e24, (level_6 / grid_length));
    return barchantangentlight_1;
}

float barchan_relief_thickness()
{
    float _e3 = barchan_tables[0].greatest;
    float _e7 = barchan_tables[0].least;
    return (_e3 - _e7);
}

float4 barchan_relief_depths(float4 heights)
{
    const float _e1 = barchan_relief_thickness();
    if (!((_e1 > 0.0))) {
        return (0.0).xxxx;
    }
    float _e10 = barchan_tables[0].greatest;
    return (((_e10).xxxx - heights) / (_e1).xxxx);
}

float barchan_relief_depth(float height)
{
    const float4 _e2 = barchan_relief_depths((height).xxxx);
    return _e2.x;
}

float2 barchan_relief_in_tile(float2 place_5)
{
    float2 extent_2 = barchan_tables[0].extent;
    uint edges_1 = barchan_tables[0].edges;
    bool2 repeats_1 = bool2(((edges_1 & 1u) != 0u), ((edges_1 & 2u) != 0u));
    float2 rest_1 = (place_5 - (floor((place_5 / extent_2)) * extent_2));
    return (repeats_1 ? ((rest_1 < (0.0).xx) ? (rest_1 + extent_2) : rest_1) : place_5);
}

BarchanReliefRay ConstructBarchanReliefRay(float2 arg0, float2 arg1, float3 arg2, float arg3, bool arg4) {
    BarchanReliefRay ret = (BarchanReliefRay)0;
    ret.place = arg0;
    ret.step_ = arg1;
    ret.towards = arg2;
    ret.tangent = arg3;
    ret.is_valid = arg4;
    return ret;
}

BarchanReliefRay barchan_relief_ray(float2 place_6, float3 towards_1)
{
    bool local_2 = (bool)0;
    bool local_3 = (bool)0;
    bool local_4 = (bool)0;

    float2 spacing = barchan_tables[0].spacing;
    const float _e6 = barchan_relief_thickness();
    float thickness = max(_e6, 0.0);
    float level_7 = length(towards_1.xy);
    float way_1 = (thickness * ((abs(towards_1.x) * spacing.y) + (abs(towards_1.y) * spacing.x)));
    if ((way_1 <= (((BARCHAN_LONGEST_WAY * spacing.x) * spacing.y) * towards_1.z))) {
        local_2 = (level_7 <= (BARCHAN_STEEPEST * towards_1.z));
    } else {
        local_2 = false;
    }
    bool is_short = local_2;
    bool is_near = all((abs(place_6) <= (16777216.0).xx));
    if ((towards_1.z > 0.0)) {
        local_3 = is_short;
    } else {
        local_3 = false;
    }
    bool _e48 = local_3;
    if (_e48) {
        local_4 = is_near;
    } else {
        local_4 = false;
    }
    bool _e52 = local_4;
    if (!(_e52)) {
        const BarchanReliefRay barchanreliefray = ConstructBarchanReliefRay((0.0).xx, (0.0).xx, float3(0.0, 0.0, 1.0), 0.0, false);
        return barchanreliefray;
    }
    float run = (thickness / towards_1.z);
    float2 step_1 = (float2((-(run) * towards_1.x), (run * towards_1.y)) / spacing);
    const float2 _e74 = barchan_relief_in_tile(place_6);
    const BarchanReliefRay barchanreliefray_1 = ConstructBarchanReliefRay(_e74, step_1, towards_1, (level_7 / towards_1.z), true);
    return barchanreliefray_1;
}

BarchanReliefRay barchan_relief_ray_through(float2 place_7, float depth, float3 towards_2)
{
    const BarchanReliefRay _e3 = barchan_relief_ray(place_7, towards_2);
    if (!(_e3.is_valid)) {
        const BarchanReliefRay barchanreliefray_2 = _e3;
        return barchanreliefray_2;
    }
    const BarchanReliefRay _e10 = barchan_relief_ray((_e3.place - (depth * _e3.step_)), towards_2);
    const BarchanReliefRay barchanreliefray_3 = _e10;
    return barchanreliefray_3;
}

float2 barchan_relief_at(BarchanReliefRay ray, float depth_1)
{
    return (ray.place + (depth_1 * ray.step_));
}

float barchan_relief_way(BarchanReliefRay ray_1)
{
    return max(abs(ray_1.step_.x), abs(ray_1.step_.y));
}

float barchan_relief_way_ahead(BarchanReliefRay ray_2, float start_1)
{
    const float _e7 = barchan_relief_way(ray_2);
    return (((start_1 > 0.0) ? 0.03125 : 0.25) * _e7);
}

int2 barchan_relief_cell(BarchanReliefRay ray_3, float depth_2)
{
    const float2 _e2 = barchan_relief_at(ray_3, depth_2);
    return naga_f2i32(((ray_3.step_ < (0.0).xx) ? (ceil(_e2) - (1.0).xx) : floor(_e2)));
}

int2 barchan_relief_cell_of(BarchanReliefRay ray_4, int2 low, int2 high, float depth_3)
{
    const int2 _e4 = barchan_relief_cell(ray_4, depth_3);
    return clamp(_e4, low, asint(asuint(high) - asuint((int(1)).xx)));
}

BarchanReliefExit ConstructBarchanReliefExit(float arg0, int2 arg1) {
    BarchanReliefExit ret = (BarchanReliefExit)0;
    ret.depth = arg0;
    ret.next = arg1;
    return ret;
}

BarchanReliefExit barchan_relief_exit(BarchanReliefRay ray_5, int2 low_1, int2 high_1, float start_2)
{
    int2 next = (int2)0;

    bool2 moves = (ray_5.step_ != (0.0).xx);
    const int2 _e12 = barchan_chosen(low_1, high_1, (ray_5.step_ > (0.0).xx));
    float2 ends = float2(_e12);
    float2 borders = (moves ? ((ends - ray_5.place) / (moves ? ray_5.step_ : (1.0).xx)) : (1e30).xx);
    float depth_8 = min(max(min(borders.x, borders.y), start_2), 1.0);
    const int2 _e30 = barchan_relief_cell_of(ray_5, low_1, high_1, depth_8);
    next = _e30;
    const int2 _e39 = barchan_chosen(high_1, asint(asuint(low_1) - asuint((int(1)).xx)), (ray_5.step_ < (0.0).xx));
    if ((borders.x <= borders.y)) {
        next.x = _e39.x;
    } else {
        next.y = _e39.y;
    }
    int2 _e47 = next;
    const BarchanReliefExit barchanreliefexit = ConstructBarchanReliefExit(depth_8, _e47);
    return barchanreliefexit;
}

float4 barchan_relief_corners(int2 cell)
{
    const float _e2 = barchan_height_texel(cell, int(0));
    const float _e8 = barchan_height_texel(asint(asuint(cell) + asuint(int2(int(1), int(0)))), int(0));
    const float _e14 = barchan_height_texel(asint(asuint(cell) + asuint(int2(int(0), int(1)))), int(0));
    const float _e20 = barchan_height_texel(asint(asuint(cell) + asuint(int2(int(1), int(1)))), int(0));
    const float4 _e22 = barchan_relief_depths(float4(_e2, _e8, _e14, _e20));
    return _e22;
}

float barchan_relief_twist(float4 corners)
{
    return ((corners.x - corners.y) + (corners.w - corners.z));
}

float barchan_relief_cell_gap(BarchanReliefRay ray_6, int2 cell_1, float4 corners_1, float depth_4)
{
    float2 place_9 = ((ray_6.place - float2(cell_1)) + (depth_4 * ray_6.step_));
    float plane = ((corners_1.x + ((corners_1.y - corners_1.x) * place_9.x)) + ((corners_1.z - corners_1.x) * place_9.y));
    const float _e23 = barchan_relief_twist(corners_1);
    return ((plane + ((_e23 * place_9.x) * place_9.y)) - depth_4);
}

float barchan_relief_gap(BarchanReliefRay ray_7, float depth_5)
{
    const float2 _e2 = barchan_relief_at(ray_7, depth_5);
    int2 cell_7 = naga_f2i32(floor(_e2));
    const float4 _e5 = barchan_relief_corners(cell_7);
    const float _e6 = barchan_relief_cell_gap(ray_7, cell_7, _e5, depth_5);
    return _e6;
}

float barchan_relief_first_zero(float g0_, float g1_, float c)
{
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;
    bool local_7 = (bool)0;
    float s = 1.0;
    bool local_8 = (bool)0;

    if ((g0_ <= 0.0)) {
        return 0.0;
    }
    float b = ((g1_ - g0_) - c);
    float discriminant = ((b * b) - ((4.0 * c) * g0_));
    if ((g1_ > 0.0)) {
        if (!((c <= 0.0))) {
            local_6 = (b >= 0.0);
        } else {
            local_6 = true;
        }
        bool _e25 = local_6;
        if (!(_e25)) {
            local_7 = (discriminant < 0.0);
        } else {
            local_7 = true;
        }
        bool _e32 = local_7;
        local_5 = _e32;
    } else {
        local_5 = false;
    }
    bool _e34 = local_5;
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
        local_8 = (_e55 > 1.0);
    } else {
        local_8 = false;
    }
    bool _e59 = local_8;
    if (_e59) {
        return -1.0;
    }
    float _e61 = s;
    return min(_e61, 1.0);
}

float barchan_relief_hit(BarchanReliefRay ray_8, int2 cell_2, float4 corners_2, float start_3, float end)
{
    float part_1 = (end - start_3);
    const float _e6 = barchan_relief_twist(corners_2);
    float twist = ((_e6 * (part_1 * ray_8.step_.x)) * (part_1 * ray_8.step_.y));
    const float _e15 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, start_3);
    const float _e16 = barchan_relief_cell_gap(ray_8, cell_2, corners_2, end);
    const float _e17 = barchan_relief_first_zero(_e15, _e16, twist);
    return ((_e17 < 0.0) ? -1.0 : (start_3 + (_e17 * part_1)));
}

BarchanReliefLeft ConstructBarchanReliefLeft(float arg0, float arg1, bool arg2, int arg3) {
    BarchanReliefLeft ret = (BarchanReliefLeft)0;
    ret.outside = arg0;
    ret.inside = arg1;
    ret.is_within = arg2;
    ret.fetches = arg3;
    return ret;
}

BarchanReliefLeft barchan_relief_leave(BarchanReliefRay ray_9, BarchanStart start_4, float step_)
{
    bool local_9 = (bool)0;
    float inside = (float)0;
    int fetches = int(1);

    float depth_9 = ((start_4.depth > 0.0) ? min(start_4.depth, 1.0) : 0.0);
    if (!(start_4.is_proven)) {
        local_9 = (depth_9 == 0.0);
    } else {
        local_9 = true;
    }
    bool _e18 = local_9;
    if (_e18) {
        const BarchanReliefLeft barchanreliefleft = ConstructBarchanReliefLeft(depth_9, depth_9, false, int(0));
        return barchanreliefleft;
    }
    const float _e22 = barchan_relief_gap(ray_9, depth_9);
    if ((_e22 > 0.0)) {
        const BarchanReliefLeft barchanreliefleft_1 = ConstructBarchanReliefLeft(depth_9, depth_9, false, int(1));
        return barchanreliefleft_1;
    }
    inside = depth_9;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e48 = fetches;
            fetches = asint(asuint(_e48) + asuint(int(1)));
        }
        loop_init = false;
        int _e31 = fetches;
        if ((_e31 <= BARCHAN_MOST_TURNS)) {
        } else {
            break;
        }
        {
            float _e34 = inside;
            float outside = (_e34 - step_);
            if ((outside <= 0.0)) {
                break;
            }
            const float _e38 = barchan_relief_gap(ray_9, outside);
            if ((_e38 > 0.0)) {
                float _e41 = inside;
                int _e43 = fetches;
                const BarchanReliefLeft barchanreliefleft_2 = ConstructBarchanReliefLeft(outside, _e41, true, asint(asuint(_e43) + asuint(int(1))));
                return barchanreliefleft_2;
            }
            inside = outside;
        }
    }
    float _e50 = inside;
    int _e52 = fetches;
    const BarchanReliefLeft barchanreliefleft_3 = ConstructBarchanReliefLeft(0.0, _e50, true, _e52);
    return barchanreliefleft_3;
}

BarchanStart ConstructBarchanStart(float arg0, bool arg1, int2 arg2) {
    BarchanStart ret = (BarchanStart)0;
    ret.depth = arg0;
    ret.is_proven = arg1;
    ret.fetches = arg2;
    return ret;
}

BarchanStart barchan_relief_start(BarchanReliefRay ray_10)
{
    const BarchanStart barchanstart = ConstructBarchanStart(0.0, true, (int(0)).xx);
    return barchanstart;
}

int barchan_mip_coarsest()
{
    uint _e3 = barchan_tables[11].first_level;
    uint _e7 = barchan_tables[11].levels;
    return asint(asuint(int((_e3 + _e7))) - asuint(int(1)));
}

int barchan_mip_finest()
{
    uint _e3 = barchan_tables[11].first_level;
    return max(int(_e3), int(1));
}

int barchan_mip_level_as_long_as(float way, int most)
{
    int level_1 = int(0);
    bool local_10 = (bool)0;

    while(true) {
        int _e4 = level_1;
        if ((_e4 < most)) {
            int _e8 = level_1;
            local_10 = (float((int(2) << uint(_e8))) <= way);
        } else {
            local_10 = false;
        }
        bool _e15 = local_10;
        if (_e15) {
        } else {
            break;
        }
        {
            int _e17 = level_1;
            level_1 = asint(asuint(_e17) + asuint(int(1)));
        }
    }
    int _e19 = level_1;
    int _e20 = level_1;
    const int _e21 = barchan_mip_finest();
    return ((_e20 < _e21) ? int(0) : _e19);
}

int naga_mod(int lhs, int rhs) {
    int divisor = ((lhs == int(-2147483647 - 1) & rhs == -1) | (rhs == 0)) ? 1 : rhs;
    return lhs - (lhs / divisor) * divisor;
}

int3 barchan_mip_range(bool repeats, int cell_3, int size, int level_2)
{
    bool local_11 = (bool)0;
    bool local_12 = (bool)0;

    int last = asint(asuint(max((size >> uint(level_2)), int(1))) - asuint(int(1)));
    int repeated_1 = naga_mod(asint(asuint(naga_mod(cell_3, size)) + asuint(size)), size);
    int inside_1 = (repeats ? repeated_1 : clamp(cell_3, int(0), asint(asuint(size) - asuint(int(1)))));
    int tile = (repeats ? asint(asuint(cell_3) - asuint(inside_1)) : int(0));
    int texel = min((inside_1 >> uint(level_2)), last);
    int low_2 = (texel << uint(level_2));
    int high_2 = ((texel == last) ? size : (asint(asuint(texel) + asuint(int(1))) << uint(level_2)));
    if (repeats) {
        return int3(asint(asuint(tile) + asuint(low_2)), asint(asuint(tile) + asuint(high_2)), texel);
    }
    if ((level_2 == int(0))) {
        local_11 = (cell_3 < int(0));
    } else {
        local_11 = false;
    }
    bool _e42 = local_11;
    if (_e42) {
        return int3(int(-33554432), int(0), texel);
    }
    if ((level_2 > int(0))) {
        local_12 = (texel == int(0));
    } else {
        local_12 = false;
    }
    bool _e54 = local_12;
    return int3((_e54 ? int(-33554432) : low_2), ((texel == last) ? BARCHAN_ENDLESS : high_2), texel);
}

BarchanMipBlock ConstructBarchanMipBlock(int2 arg0, int2 arg1, int2 arg2) {
    BarchanMipBlock ret = (BarchanMipBlock)0;
    ret.low = arg0;
    ret.high = arg1;
    ret.texel = arg2;
    return ret;
}

BarchanMipBlock barchan_mip_block(int level_3, int2 cell_4)
{
    float2 _e5 = barchan_tables[0].extent;
    int2 extent_3 = naga_f2i32(_e5);
    uint edges_2 = barchan_tables[0].edges;
    const int3 _e17 = barchan_mip_range(((edges_2 & 1u) != 0u), cell_4.x, extent_3.x, level_3);
    const int3 _e24 = barchan_mip_range(((edges_2 & 2u) != 0u), cell_4.y, extent_3.y, level_3);
    const BarchanMipBlock barchanmipblock = ConstructBarchanMipBlock(int2(_e17.x, _e24.x), int2(_e17.y, _e24.y), int2(_e17.z, _e24.z));
    return barchanmipblock;
}

int barchan_mip_level_behind(BarchanReliefRay ray_11, int level_4, int2 cell_5, int2 next_1, float gap)
{
    bool local_13 = (bool)0;

    const int _e7 = barchan_mip_finest();
    int above = max(asint(asuint(level_4) + asuint(int(1))), _e7);
    const float _e9 = barchan_relief_way(ray_11);
    bool is_high = ((gap * _e9) > float((int(1) << uint(above))));
    const int _e16 = barchan_mip_coarsest();
    if (!((above > _e16))) {
        local_13 = !(is_high);
    } else {
        local_13 = true;
    }
    bool _e23 = local_13;
    if (_e23) {
        return level_4;
    }
    const BarchanMipBlock _e24 = barchan_mip_block(above, cell_5);
    const BarchanMipBlock _e26 = barchan_mip_block(above, next_1);
    bool goes_on = all((_e24.texel == _e26.texel));
    return (goes_on ? level_4 : above);
}

BarchanFound ConstructBarchanFound(float arg0, int2 arg1) {
    BarchanFound ret = (BarchanFound)0;
    ret.depth = arg0;
    ret.fetches = arg1;
    return ret;
}

BarchanFound barchan_relief_search(BarchanReliefRay ray_12, BarchanStart start_5)
{
    int2 fetches_1 = (int2)0;
    float depth_6 = (float)0;
    int2 cell_6 = (int2)0;
    int level_5 = (int)0;
    int turn = int(0);
    float gap_1 = (float)0;
    bool local_14 = (bool)0;

    const BarchanReliefLeft _e3 = barchan_relief_leave(ray_12, start_5, BARCHAN_STEP_BACK);
    uint _e7 = barchan_tables[11].first_level;
    int first_level = int(_e7);
    fetches_1 = asint(asuint(start_5.fetches) + asuint(int2(_e3.fetches, int(0))));
    depth_6 = _e3.outside;
    float _e17 = depth_6;
    const int2 _e18 = barchan_relief_cell(ray_12, _e17);
    cell_6 = _e18;
    float _e20 = depth_6;
    const float _e21 = barchan_relief_way_ahead(ray_12, _e20);
    const int _e22 = barchan_mip_coarsest();
    const int _e23 = barchan_mip_level_as_long_as(_e21, _e22);
    level_5 = _e23;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e113 = turn;
            turn = asint(asuint(_e113) + asuint(int(1)));
        }
        loop_init_1 = false;
        int _e27 = turn;
        if ((_e27 < BARCHAN_MOST_TURNS)) {
        } else {
            break;
        }
        {
            int _e30 = level_5;
            int2 _e31 = cell_6;
            const BarchanMipBlock _e32 = barchan_mip_block(_e30, _e31);
            float _e35 = depth_6;
            const BarchanReliefExit _e36 = barchan_relief_exit(ray_12, _e32.low, _e32.high, _e35);
            gap_1 = 0.0;
            int _e39 = level_5;
            if ((_e39 == int(0))) {
                int _e44 = fetches_1.x;
                fetches_1.x = asint(asuint(_e44) + asuint(int(1)));
                int2 _e46 = cell_6;
                const float4 _e47 = barchan_relief_corners(_e46);
                int2 _e48 = cell_6;
                float _e49 = depth_6;
                const float _e51 = barchan_relief_hit(ray_12, _e48, _e47, _e49, _e36.depth);
                if ((_e51 >= 0.0)) {
                    int2 _e54 = fetches_1;
                    const BarchanFound barchanfound = ConstructBarchanFound(_e51, _e54);
                    return barchanfound;
                }
                if ((_e36.depth >= 1.0)) {
                    int2 _e59 = fetches_1;
                    const BarchanFound barchanfound_1 = ConstructBarchanFound(1.0, _e59);
                    return barchanfound_1;
                }
                int2 _e62 = cell_6;
                const float _e64 = barchan_relief_cell_gap(ray_12, _e62, _e47, _e36.depth);
                gap_1 = _e64;
            } else {
                int _e67 = fetches_1.y;
                fetches_1.y = asint(asuint(_e67) + asuint(int(1)));
                int _e70 = level_5;
                const float _e72 = barchan_maximum_mip_texel(_e32.texel, asint(asuint(_e70) - asuint(first_level)));
                const float _e73 = barchan_relief_depth(_e72);
                if ((_e73 > _e36.depth)) {
                    local_14 = (_e36.depth < 1.0);
                } else {
                    local_14 = false;
                }
                bool _e82 = local_14;
                if (!(_e82)) {
                    float _e84 = depth_6;
                    depth_6 = max(_e84, min(_e73, _e36.depth));
                    float _e89 = depth_6;
                    const float _e91 = barchan_relief_way(ray_12);
                    float way_left = ((_e36.depth - _e89) * _e91);
                    float _e95 = depth_6;
                    const int2 _e96 = barchan_relief_cell_of(ray_12, _e32.low, _e32.high, _e95);
                    cell_6 = _e96;
                    int _e99 = level_5;
                    const int _e102 = barchan_mip_level_as_long_as((BARCHAN_LONGEST_BLOCK * way_left), asint(asuint(_e99) - asuint(int(1))));
                    level_5 = _e102;
                    continue;
                }
                gap_1 = (_e73 - _e36.depth);
            }
            int _e105 = level_5;
            int2 _e106 = cell_6;
            float _e108 = gap_1;
            const int _e109 = barchan_mip_level_behind(ray_12, _e105, _e106, _e36.next, _e108);
            level_5 = _e109;
            depth_6 = _e36.depth;
            cell_6 = _e36.next;
        }
    }
    float _e115 = depth_6;
    int2 _e116 = fetches_1;
    const BarchanFound barchanfound_2 = ConstructBarchanFound(_e115, _e116);
    return barchanfound_2;
}

BarchanFound barchan_relief_find(BarchanReliefRay ray_13)
{
    if (!(ray_13.is_valid)) {
        const BarchanFound barchanfound_3 = ConstructBarchanFound(0.0, (int(0)).xx);
        return barchanfound_3;
    }
    const BarchanStart _e7 = barchan_relief_start(ray_13);
    const BarchanFound _e8 = barchan_relief_search(ray_13, _e7);
    const BarchanFound barchanfound_4 = _e8;
    return barchanfound_4;
}

float2 barchan_probe_place(float4 position_2)
{
    float2 _e3 = barchan_probe.place;
    float2 _e8 = barchan_probe.step_;
    return (_e3 + (floor(position_2.xy) * _e8));
}

bool barchan_relief_in_shadow(float2 place_8, float depth_7, float3 towards_3, float tolerance)
{
    bool local_15 = (bool)0;

    const BarchanReliefRay _e4 = barchan_relief_ray_through(place_8, depth_7, towards_3);
    if (!(_e4.is_valid)) {
        return true;
    }
    float clear = (depth_7 - tolerance);
    const BarchanStart _e9 = barchan_relief_start(_e4);
    if (_e9.is_proven) {
        local_15 = (_e9.depth >= clear);
    } else {
        local_15 = false;
    }
    bool _e16 = local_15;
    if (_e16) {
        return false;
    }
    const BarchanFound _e18 = barchan_relief_search(_e4, _e9);
    return (_e18.depth < clear);
}

float4 barchan_probe_vertex(uint index : SV_VertexID) : SV_Position
{
    return float4(((float((index & 1u)) * 4.0) - 1.0), ((float((index >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

float4 barchan_probe_relief(FragmentInput_barchan_probe_relief fragmentinput_barchan_probe_relief) : SV_Target0
{
    float4 position = fragmentinput_barchan_probe_relief.position_3;
    const float2 _e1 = barchan_probe_place(position);
    float3 _e4 = barchan_probe.eye;
    const BarchanReliefRay _e5 = barchan_relief_ray(_e1, _e4);
    if (!(_e5.is_valid)) {
        return float4(-1.0, 0.0, 0.0, 0.0);
    }
    const BarchanStart _e13 = barchan_relief_start(_e5);
    const BarchanFound _e14 = barchan_relief_search(_e5, _e13);
    return float4(_e14.depth, float2(_e14.fetches), _e13.depth);
}

float4 barchan_probe_relief_shadow(FragmentInput_barchan_probe_relief_shadow fragmentinput_barchan_probe_relief_shadow) : SV_Target0
{
    float4 position_1 = fragmentinput_barchan_probe_relief_shadow.position_4;
    const float2 _e1 = barchan_probe_place(position_1);
    float3 _e4 = barchan_probe.eye;
    const BarchanReliefRay _e5 = barchan_relief_ray(_e1, _e4);
    const BarchanFound _e6 = barchan_relief_find(_e5);
    float depth_10 = _e6.depth;
    const float2 _e8 = barchan_relief_at(_e5, depth_10);
    float3 _e11 = barchan_probe.light;
    float _e14 = barchan_probe.tolerance;
    const bool _e15 = barchan_relief_in_shadow(_e8, depth_10, _e11, _e14);
    return float4(depth_10, (_e15 ? 1.0 : 0.0), 0.0, 0.0);
}
