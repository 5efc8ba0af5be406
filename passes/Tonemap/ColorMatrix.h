// Matrices of colours, and the change from one white to another. Source: the Bradford adaptation (Lam 1985).
#pragma once

#include "DrydockAPI.h"

#include <array>

namespace Drydock
{

/** Rows of a matrix on column vectors. */
using FColorMatrix = std::array<std::array<double, 3>, 3>;

/** XYZ, or the components of some primaries. */
using FColorVector = std::array<double, 3>;

DRYDOCK_API FColorMatrix Multiply(const FColorMatrix& A, const FColorMatrix& B);
DRYDOCK_API FColorVector Multiply(const FColorMatrix& Matrix, const FColorVector& Color);

/** 0: the matrix has no inverse. */
DRYDOCK_API double GetDeterminant(const FColorMatrix& Matrix);

/** The inverse of a matrix that has one. */
DRYDOCK_API FColorMatrix Invert(const FColorMatrix& Matrix);

/** XYZ of a chromaticity of the CIE 1931 diagram, at luminance 1. */
DRYDOCK_API FColorVector MakeWhite(double X, double Y);

/** Makes white under To of what is white under From; both are as MakeWhite gives them. */
DRYDOCK_API FColorMatrix MakeAdaptation(const FColorVector& From, const FColorVector& To);

} // namespace Drydock
