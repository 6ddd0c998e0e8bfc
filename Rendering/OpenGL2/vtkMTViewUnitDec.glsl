// SPDX-License-Identifier: BSD-3-Clause
// Fragment shader: eye coordinates times this are near 1, so that their squares are floats.
uniform float viewUnit;
