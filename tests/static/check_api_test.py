# SPDX-License-Identifier: MIT
"""What check_api.py finds: names that are not listed, words that were left."""
import unittest

import check_api
from check_source_test import Tree


class Declarations(unittest.TestCase):
    def names(self, text):
        return [name for _, _, name in check_api.declarations(text)]

    def test_each_kind_is_seen(self):
        text = """// namespace batuta { struct Comment; }
        namespace batuta {
        struct Forward;
        template <class T, int N = (1 > 0 ? 2 : 3)> class Pool final : Base<T> { int member; void call(); };
        enum class [[nodiscard]] Status : std::uint8_t { kOk, kBad };
        template <class T> using Vec3 = Eigen::Matrix<T, 3, 1>;
        template <class T> inline constexpr T kRoundOff = T{1} << 24;
        constexpr int clamp(int x, int low = 0) { if (x < low) { return low; } return x; }
        [[nodiscard]] Result<Vec3<float>> make(const Vec3<float>& p = {0, 0, 0});
        template <class T> void Pool<T>::call() { int local = 0; }
        }"""
        self.assertEqual(self.names(text), ["Forward", "Pool", "Status", "Vec3", "kRoundOff", "clamp", "make"])

    def test_namespaces_are_told_apart(self):
        text = "namespace batuta {\nnamespace detail {\nint a();\n}\n}\nnamespace batuta::fencing {\nclass Duel {};\n}\n"
        self.assertEqual(list(check_api.declarations(text)),
                         [("batuta::detail", "function", "a"), ("batuta::fencing", "class", "Duel")])


class Listed(Tree):
    def test_what_is_new_and_what_is_gone_are_found(self):
        self.put("include/batuta/core/a.hpp", "namespace batuta {\nint kept();\nint fresh();\nnamespace detail {\nint hidden();\n}\n}\n")
        self.put("include/batuta/core/detail/b.hpp", "namespace batuta::detail {\nint machinery();\n}\n")
        self.put(check_api.LIST, "batuta function gone core/a.hpp\nbatuta function kept core/a.hpp\n")
        self.assert_found(check_api.check_listed(self.root), "lacks: batuta function fresh", "not declared: batuta function gone")
        self.assertEqual(check_api.check_listed(self.root, update=True), [])
        self.assertEqual(check_api.check_listed(self.root), [])

    def test_a_full_namespace_is_found(self):
        names = "".join(f"int name_{i}();\n" for i in range(check_api.MOST_FLAT + 1))
        self.put("include/batuta/core/a.hpp", "namespace batuta {\n" + names + "}\n")
        self.put("tests/static/.keep", "")
        self.assert_found(check_api.check_listed(self.root, update=True), "221 names directly")


class Left(Tree):
    def test_words_that_were_left_are_found(self):
        self.put("include/batuta/world/a.hpp", "Course<float> x;  // a driver, of old\nint slab = 0;\nvoid tell(Driver d);\n")
        self.put("port/platforms/host/h.cpp", "body.momentum.p_W = v;\nint driver = 0;\n")
        self.put("tests/unit/world/t.cpp", "BodyPair pair;\n")
        self.assert_found(check_api.check_left(self.root), "'Course' was left", "'slab' was left", "'Driver' was left",
                          "p_W is a position", "'BodyPair' was left")

    def test_other_meanings_are_kept(self):
        self.put("port/platforms/stm32f405/drivers/d.cpp", "class Driver {};\n")
        self.put("src/core/a.cpp", "// the answer was told\nint answered = 0;\nconst char* text = \"driver\";\n")
        self.assertEqual(check_api.check_left(self.root), [])


if __name__ == "__main__":
    unittest.main()
