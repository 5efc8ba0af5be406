// Rewrites parts of today's HLSL that the front end lacks or gets wrong, among the tokens of a preprocessed text. A
// part that cannot be rewritten is an error at its token.
#pragma once

#include "HlslSymbols.h"

namespace Drydock
{

/** All of what follows. A text that has nothing of it comes back as it is. VirtualPath: of lines above the first #line.
 * Errors: DD6010. bRealHalf: half is float16_t, not float. */
DRYDOCK_API std::string RewriteHlsl(
	const std::string& Text, const std::string& VirtualPath, std::vector<FDiagnostic>& Errors, bool bRealHalf = false);

// Each tells whether it changed the text; Symbols are those of the text as it is given.

/** Templates of functions and structs: each use with arguments of its own gets a copy, F<float> as F_float. */
bool RewriteTemplates(FHlslText& Text, std::vector<FDiagnostic>& Errors);

/** uint32_t3 and its like by HLSL's older names; attributes in small letters; `using A = B;` as a typedef; vectors and
 * literals of 16 and 64 bits as the front end reads them. */
bool RewriteNames(FHlslText& Text, bool bRealHalf);

/** `struct B : A`, which the front end takes without what A has: its members are written into B. */
bool RewriteBases(FHlslText& Text);

/** `float G;` at file scope that functions write to: HLSL's older mode writes to a copy of the parameter. */
bool RewriteGlobals(FHlslText& Text, const FHlslSymbols& Symbols);

/** `C ? A : B`, `A && B` and `A || B` as if statements where a wave or an atomic operation is in what only some threads
 * reach. */
bool RewriteChoices(FHlslText& Text, std::vector<FDiagnostic>& Errors);

/** `Out[P].rgb = V` of a texture or typed buffer as read, change and write of the texel; `M._m00_m11 = V` by elements;
 * [unroll(N)] as a bound of the loop's steps. */
bool RewriteStatements(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors);

/** Intrinsics that the front end lacks (AddUint64, dot4add_u8packed, msad4, ...) or gets wrong
 * (InterlockedCompareStore, WaveActiveAllEqual of vectors), by functions before the text. */
bool RewriteCalls(FHlslText& Text, const FHlslSymbols& Symbols);

/** Matrices made of other parts than their rows, those of bool, and mul of integers, by functions before the text. */
bool RewriteMatrices(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors);

/** Resources in arrays, local variables and structs, as numbers. */
bool RewriteResources(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors);

/** Load<T> and Store<T> of buffers of bytes, by functions; a ConstantBuffer<S> whose S is that of an
 * RWStructuredBuffer. */
bool RewriteBuffers(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors);

/** select, and, or; `M._m00_m11`; initializer lists as arguments; abs and sign of uint; and the calls that the front
 * end folds wrongly when their arguments are constants. */
bool RewriteExpressions(FHlslText& Text, const FHlslSymbols& Symbols, std::vector<FDiagnostic>& Errors);

/** Element Index of a value, counted row by row: "V[1]", "V[0][2]", a scalar itself. */
std::string GetHlslElement(const std::string& Value, const FHlslNumeric& Type, int Index);

/** "_m00_m11" and "_11_22" by their elements, each "_m00"; empty if Swizzle does not name several elements. */
std::vector<std::string> SplitMatrixSwizzle(const std::string& Swizzle);

} // namespace Drydock
