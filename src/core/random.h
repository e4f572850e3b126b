// Random draws by address: nothing is "next". A draw is a pure function of (seed, address), so the order in which draws are
// made, the number of threads and what else a scene holds do not show in it.
//
// The generator is Philox 4x32-10 (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC11), from Random123.
#pragma once

#include <cstdint>
#include <string_view>

namespace shatterpave {

// What a draw is for. Values are fixed for ever: renumbering one changes every user's pictures. Append only.
enum class Stream : std::uint32_t {
  radial_count = 1,     // M of an impact (eq. 5)
  large_speed = 2,      // eq. 9
  radial_speed = 3,     // eq. 10
  ring_radius = 4,      // eq. 8
  ring_speed = 5,       // eq. 11
  turn = 6,             // F3, a draw for each tip and step
  first_direction = 7,  // direction of the first radial, and phase of the rings
  large_choice = 8,     // which of the radials are large
  large_count = 10,     // deviation of N from eq. 6
  stone_seed = 20,      // jitter of a seed of the packing
  packing = 21,         // annealing, a draw for each particle and step
  stone_height = 22,    // surface of a stone
  stone_inset = 23,
  stone_colour = 24,
  stone_relief = 25,    // place of a stone in the relief
  relief_lattice = 26,  // gradients of the fractal surface
  stone_tilt = 27,
  ashlar_size = 28,  // size of the stone at a module of random ashlar
  crazy_seed = 29,   // seed of a stone of crazy paving
  stone_place = 30,  // size, rotation and offset of a stone
  stone_missing = 31,
  stone_sink = 32,
  hand_line = 33,     // laid by hand: how far lines between stones are moved,
  hand_corner = 34,   // where each corner of a stone lies
  stone_hollow = 35,  // and which stones have sunk
  stone_arris = 36,   // arris, crown and warp of a stone with a finish
  stone_chip = 37,    // chance, place and size of a chip on a side
  ground = 38,        // heights of the ground
  colour_blur = 39,   // how far a stone's colour is off the order of the user's own colours
  debris = 40,        // crushed zone and other litter about an impact
  shard_chip = 60,
  shard_missing = 61,  // whether a shard leaves the pane
  shard_fallen = 62,   // whether one that left it lies about
  shard_throw = 63,    // how it leaves
  crack_tilt = 70,     // walls of a crack: lean,
  crack_curve = 71,    // bow,
  crack_opening = 72,  // width of the gap,
  crack_depth = 73,    // and how deep it is
  shot_hole = 74,      // flakes about the hole of a shot
  ring_piece = 80,     // pieces of rings from radial to radial: whether, where, how bowed
  branch = 81,         // where a crack branches, and how
  radial_onset = 82,   // when a radial starts
  dice_seed = 83,      // seed of a fragment of tempered glass
  through = 84,        // whether a crack runs through laminated glass
  radial_course = 85,  // radials of real panes: direction, reach, kinks
  crack_chip = 86,     // lens-shaped chips at junctions of cracks
  rung = 88,           // pieces across strips between radials
  dirt = 89,           // the place of a pane in the pattern of dirt
  hole_outline = 87,   // the hole that shards leave: its arcs and cusps
};

// Identity of an element, made from what it *is*: its names and its places among its siblings, never from a running
// counter over unlike things.
class Id {
 public:
  constexpr Id() = default;
  // FNV-1a, so that it is the same everywhere.
  constexpr explicit Id(std::string_view name) {
    for (const char c : name) mix(static_cast<unsigned char>(c));
  }
  // The `index`-th child of this.
  constexpr Id child(std::uint64_t index) const {
    Id id = *this;
    for (int byte = 0; byte < 8; ++byte) id.mix(static_cast<unsigned char>(index >> (8 * byte)));
    return id;
  }
  constexpr Id child(std::string_view name) const {
    Id id = *this;
    id.mix(0);  // so that "a", "bc" is not "ab", "c"
    for (const char c : name) id.mix(static_cast<unsigned char>(c));
    id.mix(0);
    return id;
  }
  constexpr std::uint64_t value() const { return value_; }
  constexpr bool operator==(const Id&) const = default;

 private:
  constexpr void mix(unsigned char byte) {
    value_ ^= byte;
    value_ *= 0x100000001b3ULL;
  }
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

// Where a draw stands: its purpose, its element, and its ordinal among the element's draws.
struct Address {
  Stream stream;
  Id element;
  std::uint32_t draw = 0;
};

// Uniform over [0, 1), a multiple of 2^-53.
double uniform(std::uint64_t seed, const Address& address);
// Standard normal; |result| < 8.6, since 1 - u >= 2^-53.
double normal(std::uint64_t seed, const Address& address);
// Poisson with mean >= 0, by inversion; mean <= 1e6.
int poisson(std::uint64_t seed, const Address& address, double mean);

}  // namespace shatterpave
