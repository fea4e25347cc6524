// SPDX-License-Identifier: MIT
// Of an Arduino core what sketches and libraries stumble over: macros with the names of others.
#pragma once
#include <math.h>
#include <stdint.h>

#define F(text) (reinterpret_cast<const char*>(text))
#define B0 0
#define B1 1
#define abs(x) ((x) > 0 ? (x) : -(x))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define radians(degree) ((degree)*0.017453292519943295)
#define degrees(radian) ((radian)*57.29577951308232)
#define sq(x) ((x) * (x))
#define bit(b) (1UL << (b))
#define constrain(x, low, high) ((x) < (low) ? (low) : ((x) > (high) ? (high) : (x)))

void setup();
void loop();
void delay(unsigned long milliseconds);

struct SerialPort {
  void begin(unsigned long) {}
  void print(const char*) {}
  void println(const char*) {}
  void println(double x, int digits = 2);
};
extern SerialPort Serial;
