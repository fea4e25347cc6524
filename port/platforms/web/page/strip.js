// SPDX-License-Identifier: MIT
// The strip of a bout, m: its middle is that of the salle.

export const kStripLength = 14, kStripWidth = 1.8;
const kLine = 0.04, kEndLine = 0.12;
const kEnd = (kStripLength - kEndLine) / 2;

/** Place along the strip and breadth of its lines: the ends, two metres before them, on guard, the middle. */
export const kStripLines = [[-kEnd, kEndLine], [-5, kLine], [-2, kLine], [0, kLine], [2, kLine], [5, kLine], [kEnd, kEndLine]];
