// SPDX-License-Identifier: MIT
// Nothing: the target of this file compiles the headers that nearly all tests include, once for
// all.
int main() {}
