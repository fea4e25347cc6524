// SPDX-License-Identifier: MIT
#include "programs/mass/mesh_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace batuta::mesh {
namespace {

bool ends_in(const std::string& path, std::string_view ending) {
  if (path.size() < ending.size()) return false;
  const auto same_letter = [](char a, char b) {
    const bool capital = a >= 'A' && a <= 'Z';
    return (capital ? static_cast<char>(a - 'A' + 'a') : a) == b;
  };
  return std::equal(path.end() - static_cast<std::ptrdiff_t>(ending.size()), path.end(),
                    ending.begin(), same_letter);
}

/// The bytes of a file, no more than kMostBytes. @returns what went wrong; empty: nothing
std::string read_bytes(const std::string& path, std::string& bytes) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  const auto reason = [] { return std::string(errno == 0 ? "failed" : std::strerror(errno)); };
  if (!in) return "cannot be read: " + reason();
  constexpr std::size_t kPiece = std::size_t{1} << 16;
  std::string piece(kPiece, '\0');
  while (in && bytes.size() <= kMostBytes) {  // Bound: kMostBytes / kPiece pieces
    in.read(piece.data(), static_cast<std::streamsize>(kPiece));
    bytes.append(piece, 0, static_cast<std::size_t>(in.gcount()));
  }
  if (bytes.size() > kMostBytes) return "is larger than can be taken";
  return in.bad() ? "cannot be read: " + reason() : std::string();
}

}  // namespace

OpenedMesh open_mesh(const std::string& path) {
  OpenedMesh opened;
  const bool obj = ends_in(path, ".obj");
  if (!obj && !ends_in(path, ".stl")) {
    opened.file.error = "its name must end in .obj or .stl";
    return opened;
  }
  std::string bytes;
  opened.file.error = read_bytes(path, bytes);
  if (!opened.file.ok()) return opened;
  opened.readable = true;
  opened.file = obj ? read_obj(bytes) : read_stl(bytes);
  return opened;
}

}  // namespace batuta::mesh
