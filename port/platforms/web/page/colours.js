// SPDX-License-Identifier: MIT
// The two fencers' colours, the same in salle, drawing, plots and laboratory.

export const kBodyColours = [0xb9cdea, 0xeccfa4];
export const kTraceColours = [0x4aa3ff, 0xff9c45];
export const kCss = ["#4aa3ff", "#ff9c45"];
