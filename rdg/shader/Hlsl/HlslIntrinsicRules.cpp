// Functions of HLSL: whether there is one of a name, and what a call of it comes to.
#include "HlslIntrinsics.h"

#include "HlslConversions.h"
#include "HlslIntrinsicTable.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

/** mul of vectors and matrices: a vector is a row on the left and a column on the right. A part that is
 * too long is cut, but no matrix for a vector on its right. */
FIntrinsicCall FindIntrinsicProduct(FTypes& Types, std::string_view Name, const FType* A, const FType* B)
{
	const EScalar Scalar = *FitScalar(Types, 'n', MeetScalars(A->Scalar, B->Scalar));
	const uint32_t Inner = std::min<uint32_t>(A->Columns, B->IsMatrix() ? B->Rows : B->Columns);
	if (A->IsMatrix() && B->IsVector() && A->Columns > Inner)
	{
		FIntrinsicCall Refused;
		Refused.Error =
			"X3020: type mismatch: 'mul' of " + GetName(A) + " and " + GetName(B) +
			": the vector on the right has to have as many components as the matrix has columns; cast the matrix";
		return Refused;
	}
	const auto Cut = [&](const FType* Type, uint32_t Rows, uint32_t Columns)
	{
		return Type->IsMatrix() ? Types.Matrix(Scalar, Rows, Columns, Type->Order) : Types.Vector(Scalar, Inner);
	};
	FIntrinsicCall Call;
	Call.Name = Name;
	Call.Parameters = {Cut(A, A->Rows, Inner), Cut(B, Inner, B->Columns)};
	Call.bOut = {false, false};
	Call.Result = A->IsMatrix() && B->IsMatrix() ? Types.Matrix(Scalar, A->Rows, B->Columns, A->Order)
				  : A->IsMatrix()                ? Types.Vector(Scalar, A->Rows)
				  : B->IsMatrix()                ? Types.Vector(Scalar, B->Columns)
												 : Types.Scalar(Scalar);
	return Call;
}

} // namespace

bool IsIntrinsic(std::string_view Name)
{
	return FindIntrinsic(Name) != nullptr;
}

std::vector<std::string> ListIntrinsics()
{
	std::vector<std::string> Names;
	for (const FIntrinsic& Function : GetIntrinsics())
	{
		if (Function.Refused.empty())
		{
			Names.emplace_back(Function.Name);
		}
	}
	return Names;
}

bool IsPure(std::string_view Name)
{
	const FIntrinsic* const Function = FindIntrinsic(Name);
	return Function && Function->bPure;
}

FIntrinsicCall FindIntrinsicCall(FTypes& Types, std::string_view Name, const std::vector<const FType*>& Arguments)
{
	FIntrinsicCall Call;
	const FIntrinsic* const Function = FindIntrinsic(Name);
	const std::string Quoted = "'" + std::string(Name) + "'";
	if (!Function)
	{
		Call.Error = "X3004: undeclared identifier " + Quoted;
		return Call;
	}
	if (!Function->Refused.empty())
	{
		Call.Error = Quoted + " cannot be called: " + std::string(Function->Refused);
		return Call;
	}
	const auto IsWide = [](const FType* Type)
	{
		return Type->IsVector() || Type->IsMatrix();
	};
	if (Name == "mul" && Arguments.size() == 2 && IsWide(Arguments[0]) && IsWide(Arguments[1]))
	{
		return FindIntrinsicProduct(Types, Function->Name, Arguments[0], Arguments[1]);
	}
	FIntrinsicCall Chosen = ChooseSignature(Types, Function->Name, Function->Signatures, Arguments);
	for (size_t i = 0; Name == "mul" && i < Chosen.Parameters.size(); ++i)
	{
		// A factor stays a scalar: of two matrices the product is another one.
		Chosen.Parameters[i] = IsWide(Arguments[i]) ? Chosen.Parameters[i] : Types.Scalar(Chosen.Result->Scalar);
	}
	return Chosen;
}

} // namespace Drydock::Hlsl
