// Signatures of HLSL's functions and of its resources' methods as data, and the choice among them by a call's
// arguments.
#pragma once

#include "HlslIntrinsics.h"

#include <optional>
#include <span>

namespace Drydock::Hlsl
{

/**
 * Signatures are written "result(parameter, parameter, ...)", each of them a letter for its scalar, then one for its
 * shape.
 *
 * Small letters of a class: all parameters of a class meet in one scalar of that class, which the result has too.
 *   n number (bools are ints)   r real (doubles become floats)   d real, doubles stay   i integer   a anything
 *   x 32 bits (float, int, uint)   y 16 bits   e integer of 32 or 64 bits, or float   j int or uint   k int64_t or
 * uint64_t Letters of one scalar: f float   h half   H float16_t   s int   u uint   b bool   D double   S int16_t   W
 * uint16_t Letters of a resource's method: c coordinates of a sample   l the same without the slice   g gradient   o
 * offset in texels   p position of a load E the element   V four of the element's scalar   z sampler   Z comparing
 * sampler   N size (int, uint or float, as asked) B the type between < and >   M any type that lies in memory "void" is
 * a result.
 *
 * Shapes: none is a scalar; 1 to 4 a vector; * the shape that all parameters with a * meet in; v the same, but no
 * matrix; m any matrix; q a square matrix; t (of a result) the matrix turned.
 *
 * Before a parameter: > it is written; & it is a place that is read and written, of just its type; ? it may lack, and
 * so may what follows it.
 */
struct FPattern
{
	char Scalar = 0;
	char Shape = 0;
	bool bOut = false;
	bool bPlace = false;
	bool bOptional = false;

	bool IsVoid() const { return Scalar == 0; }
};

struct FSignature
{
	FPattern Result;
	std::vector<FPattern> Parameters;
};

FSignature ReadSignature(std::string_view Text);

/** A function: its overloads, the first that fits is taken. */
struct FIntrinsic
{
	std::string_view Name;
	std::vector<FSignature> Signatures;
	bool bPure = true;
	std::string_view Refused; // not empty: why it cannot be called, and what to write
};

/** Null: HLSL has none of this name. */
const FIntrinsic* FindIntrinsic(std::string_view Name);
std::span<const FIntrinsic> GetIntrinsics();

/** The types that a signature's letters stand for in a method. */
struct FMethodContext
{
	const FType* Object = nullptr;
	const FType* Template = nullptr; // between < and >
};

/** Methods of objects: a row has one signature for all objects of its set and all of its names. */
struct FMethodRow
{
	uint32_t Objects = 0; // bits of EObject
	std::string_view Names;
	std::string_view Signature;
};
std::span<const FMethodRow> GetMethodRows();

/** The signature that fits. If none does, FIntrinsicCall::Error has the expected ones. Signatures: those of one
 * name. */
FIntrinsicCall ChooseSignature(FTypes& Types, std::string_view Name, std::span<const FSignature> Signatures,
	const std::vector<const FType*>& Arguments, const FMethodContext* Method = nullptr);

/** The type of a method's letter (c l g o p E V z Z N B M) for an argument, which is null where none is given. */
const FType* MakeMethodType(FTypes& Types, char Letter, const FMethodContext& Method, const FType* Argument);

/** A class's scalar for what its arguments meet in: literals and bools become numbers. Nothing where it does not fit.
 */
std::optional<EScalar> FitScalar(const FTypes& Types, char Class, EScalar Scalar);

/** Whether an argument was reported already. */
bool HasErrorType(const std::vector<const FType*>& Arguments);

/** A space-separated list's next word, which is cut off; empty at its end. */
std::string_view TakeName(std::string_view& Names);

} // namespace Drydock::Hlsl
