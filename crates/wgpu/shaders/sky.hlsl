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

static const uint BARCHAN_SKY_VISIBILITY = 5u;

cbuffer barchan_tables : register(b0) { BarchanTable barchan_tables[12]; }
SamplerState barchan_sampler : register(s1);
Texture2D<float4> barchan_sky_visibility_texels : register(t7);
cbuffer barchan_probe : register(b14) { BarchanProbe barchan_probe; }

struct FragmentInput_barchan_probe_sky {
    float4 position_2 : SV_Position;
};

float barchan_arcsine(float sine)
{
    float size = min(abs(sine), 1.0);
    bool is_steep = (size > 0.5);
    float square = (is_steep ? (0.5 * (1.0 - size)) : (size * size));
    float root = (is_steep ? sqrt(square) : size);
    float series = (((((((((((0.0421632 * square) + 0.024181312) * square) + 0.045470025) * square) + 0.074953005) * square) + 0.16666752) * square) * root) + root);
    float angle_1 = (is_steep ? (1.5707963 - (2.0 * series)) : series);
    return ((sine < 0.0) ? -(angle_1) : angle_1);
}

float barchan_arctangent(float tangent)
{
    float start = 0.0;
    float part = (float)0;

    float size_1 = abs(tangent);
    part = size_1;
    if ((size_1 > 2.4142137)) {
        start = 1.5707964;
        part = (-1.0 / size_1);
    } else {
        if ((size_1 > 0.41421357)) {
            start = 0.7853982;
            part = ((size_1 - 1.0) / (size_1 + 1.0));
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
    float2 size_2 = abs(direction);
    float larger = max(size_2.x, size_2.y);
    if (!((larger > 0.0))) {
        return 0.0;
    }
    float sine_1 = (min(size_2.x, size_2.y) / larger);
    const float _e13 = barchan_arctangent(sine_1);
    float quadrant = ((size_2.y > size_2.x) ? (1.5707964 - _e13) : _e13);
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
    int2 extent = max((whole >> ((first + uint(level))).xx), (int(1)).xx);
    uint edges = barchan_tables[table].edges;
    int2 repeated = naga_mod(asint(asuint(naga_mod(place, extent)) + asuint(extent)), extent);
    int2 clamped = clamp(place, (int(0)).xx, asint(asuint(extent) - asuint((int(1)).xx)));
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

float barchan_sky_visibility_before_transfer(int2 place_1, int layer)
{
    const int2 _e4 = barchan_inside(BARCHAN_SKY_VISIBILITY, place_1, int(0));
    float4 _e7 = barchan_sky_visibility_texels.Load(int3(_e4, layer));
    const float _e9 = barchan_scaled(BARCHAN_SKY_VISIBILITY, _e7.x);
    return _e9;
}

float barchan_sky_visibility_texel(int2 place_2, int layer_1)
{
    const float _e3 = barchan_sky_visibility_before_transfer(place_2, layer_1);
    const float _e4 = barchan_transferred(BARCHAN_SKY_VISIBILITY, _e3);
    return _e4;
}

float barchan_sky_visibility_at(float2 place_3, int layer_2)
{
    float2 _e8 = barchan_tables[5].extent;
    float2 uv = ((place_3 + (0.5).xx) / _e8);
    float4 _e13 = barchan_sky_visibility_texels.SampleLevel(barchan_sampler, uv, 0.0);
    float stored_4 = _e13.x;
    const float _e17 = barchan_scaled(BARCHAN_SKY_VISIBILITY, stored_4);
    const float _e18 = barchan_transferred(BARCHAN_SKY_VISIBILITY, _e17);
    return _e18;
}

float barchan_sky_brightness(float2 place_4)
{
    return 1.0;
}

float barchan_sky_visibility(float2 place_5)
{
    const float _e2 = barchan_sky_visibility_at(place_5, int(0));
    return _e2;
}

float barchan_sky_irradiance(float2 place_6)
{
    const float _e1 = barchan_sky_visibility(place_6);
    const float _e2 = barchan_sky_brightness(place_6);
    return (_e1 * _e2);
}

float2 barchan_probe_place(float4 position_1)
{
    float2 _e3 = barchan_probe.place;
    float2 _e8 = barchan_probe.step_;
    return (_e3 + (floor(position_1.xy) * _e8));
}

float4 barchan_probe_vertex(uint index : SV_VertexID) : SV_Position
{
    return float4(((float((index & 1u)) * 4.0) - 1.0), ((float((index >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

float4 barchan_probe_sky(FragmentInput_barchan_probe_sky fragmentinput_barchan_probe_sky) : SV_Target0
{
    float4 position = fragmentinput_barchan_probe_sky.position_2;
    const float2 _e1 = barchan_probe_place(position);
    const float _e2 = barchan_sky_visibility(_e1);
    const float _e3 = barchan_sky_irradiance(_e1);
    return float4(_e2, _e3, 0.0, 0.0);
}
