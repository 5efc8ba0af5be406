// HLSL's functions. Source: Microsoft's reference of HLSL (intrinsic functions); those with an instruction of
// GLSL.std.450 use it.
#include "HlslEmitterImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

struct FEmitExtended
{
	std::string_view Name;
	uint32_t Real;
	uint32_t Signed = 0;
	uint32_t Unsigned = 0;
};

constexpr FEmitExtended EmitExtended[] = {
	{"abs", ExtFAbs, ExtSAbs},
	{"acos", ExtAcos},
	{"asin", ExtAsin},
	{"atan", ExtAtan},
	{"atan2", ExtAtan2},
	{"ceil", ExtCeil},
	{"clamp", ExtNClamp, ExtSMax, ExtUMax}, // of integers, min(max()): bounds in the wrong order leave the upper one
	{"cos", ExtCos},
	{"cosh", ExtCosh},
	{"cross", ExtCross},
	{"degrees", ExtDegrees},
	{"distance", ExtDistance},
	{"exp", ExtExp},
	{"exp2", ExtExp2},
	{"faceforward", ExtFaceForward},
	{"floor", ExtFloor},
	{"fma", ExtFma},
	{"frac", ExtFract},
	{"length", ExtLength},
	{"lerp", ExtFMix},
	{"log", ExtLog},
	{"log2", ExtLog2},
	{"mad", ExtFma},
	{"max", ExtNMax, ExtSMax, ExtUMax},
	{"min", ExtNMin, ExtSMin, ExtUMin},
	{"normalize", ExtNormalize},
	{"pow", ExtPow},
	{"radians", ExtRadians},
	{"reflect", ExtReflect},
	{"refract", ExtRefract},
	{"round", ExtRoundEven},
	{"rsqrt", ExtInverseSqrt},
	{"sin", ExtSin},
	{"sinh", ExtSinh},
	{"smoothstep", ExtSmoothStep},
	{"sqrt", ExtSqrt},
	{"step", ExtStep},
	{"tan", ExtTan},
	{"tanh", ExtTanh},
	{"trunc", ExtTrunc},
};

constexpr double EmitLog10Of2 = 0.301029995663981195214;
constexpr double EmitColorScale = 255.001953; // of D3DCOLORtoUBYTE4

bool IsEmitBitcast(std::string_view Name)
{
	return Name == "asfloat" || Name == "asint" || Name == "asuint" || Name == "asdouble" || Name == "asfloat16" ||
		   Name == "asint16" || Name == "asuint16";
}

} // namespace

uint32_t FEmitter::Intrinsic(const FValue& Node)
{
	const std::string_view Name = Node.Name;
	if (Name.starts_with("Interlocked"))
	{
		return Interlocked(Node);
	}
	const bool bGives =
		Name == "modf" || Name == "frexp" || Name == "sincos" || (Name == "asuint" && Node.Operands.size() == 3);
	FArguments In;
	for (size_t i = 0; i < (bGives ? 1 : Node.Operands.size()); ++i)
	{
		In.push_back({Value(*Node.Operands[i]), Node.Operands[i]->Type});
	}
	uint32_t Result = 0;
	if (bGives)
	{
		return Parting(Node, In);
	}
	if (Extended(Node, In, Result))
	{
		return Result;
	}
	if (Name.starts_with("Wave") || Name.starts_with("Quad"))
	{
		return Wave(Node, In);
	}
	if (Name.find("MemoryBarrier") != std::string_view::npos)
	{
		return Barrier(Node, In);
	}
	if (Name.starts_with("dd") || Name == "fwidth")
	{
		return Derivative(Node, In);
	}
	if (IsEmitBitcast(Name))
	{
		return Reinterpret(Node, In);
	}
	return Name == "mul"                    ? Multiply(Node, In)
		   : Name == "dot"                  ? Dot(In[0].Type, In[0].Id, In[1].Id)
		   : Name == "all" || Name == "any" ? AllOrAny(Node, In)
		   : Name == "transpose"            ? Transpose(Node, In)
		   : Name == "lit" || Name == "dst" ? Lighting(Node, In)
		   : Name.starts_with("firstbit") || Name == "countbits" || Name == "reversebits" ? OfBits(Node, In)
		   : Name.starts_with("pack_") || Name.starts_with("unpack_") || Name == "f16tof32" || Name == "f32tof16"
			   ? Packing(Node, In)
		   : Name == "msad4" || Name.starts_with("dot") || Name == "AddUint64" ? Bytes(Node, In)
																			   : Simple(Node, In);
}

bool FEmitter::Extended(const FValue& Node, const FArguments& In, uint32_t& Result)
{
	const auto Row = std::ranges::find(EmitExtended, Node.Name, &FEmitExtended::Name);
	if (Row == std::end(EmitExtended) || In.empty())
	{
		return false;
	}
	const ENumber Kind = KindOf(In[0].Type->Scalar);
	const uint32_t Number = Kind == ENumber::Real ? Row->Real : Kind == ENumber::Signed ? Row->Signed : Row->Unsigned;
	const bool bScalarOf = Node.Name == "length" || Node.Name == "distance";
	if (Number == 0 && Node.Name == "mad")
	{
		Result =
			Arithmetic("+", Node.Type, Arithmetic("*", Node.Type, In[0].Id, In[1].Id, Node.Type), In[2].Id, Node.Type);
		return true;
	}
	if (Node.Name == "lerp" &&
		Bits(In[0].Type->Scalar) > 16) // the optimiser makes X of FMix(X, Y, 0), though Y is infinite
	{
		const uint32_t Way = Arithmetic("-", Node.Type, In[1].Id, In[0].Id, Node.Type);
		Result = Arithmetic("+", Node.Type, In[0].Id, Arithmetic("*", Node.Type, In[2].Id, Way, Node.Type), Node.Type);
		return true;
	}
	if (Number == 0) // abs of what has no sign
	{
		Result = In[0].Id;
		return true;
	}
	Result = bScalarOf ? Ext(Number, TypeOf(Node.Type), In.size() > 1 ? FWords{In[0].Id, In[1].Id} : FWords{In[0].Id})
					   : ByRows(Node.Type, In,
							 [&](const FType* Part, const FWords& Ids)
							 {
								 const bool bClamp = Ids.size() == 3 && (Number == ExtSMax || Number == ExtUMax);
								 const uint32_t Type = TypeOf(Part);
								 return bClamp ? Ext(Number == ExtSMax ? ExtSMin : ExtUMin, Type,
													 {Ext(Number, Type, {Ids[0], Ids[1]}), Ids[2]})
											   : Ext(Number, Type, Ids);
							 });
	return true;
}

uint32_t FEmitter::Dot(const FType* Type, uint32_t A, uint32_t B)
{
	const uint32_t Scalar = ScalarType(Type->Scalar);
	if (Type->Columns == 1)
	{
		return Arithmetic("*", Types.Scalar(Type->Scalar), A, B, Types.Scalar(Type->Scalar));
	}
	if (IsReal(Type->Scalar))
	{
		return Op(OpDot, Scalar, {A, B});
	}
	const uint32_t Product = Op(OpIMul, TypeOf(Type), {A, B});
	uint32_t Sum = Extract(Product, Type, 0);
	for (uint32_t c = 1; c < Type->Columns; ++c)
	{
		Sum = Op(OpIAdd, Scalar, {Sum, Extract(Product, Type, c)});
	}
	return Sum;
}

/** A row of HLSL is a column of SPIR-V: mul(V, M) is M times V there. */
uint32_t FEmitter::Multiply(const FValue& Node, const FArguments& In)
{
	const FType* const A = In[0].Type;
	const FType* const B = In[1].Type;
	const uint32_t Type = TypeOf(Node.Type);
	if (A->IsScalar() || B->IsScalar() || (A->Rows == B->Rows && A->Columns == B->Columns && A->IsScalar()))
	{
		const FPart& Whole = A->IsScalar() ? In[1] : In[0];
		const FPart& Factor = A->IsScalar() ? In[0] : In[1];
		if (IsRealMatrix(Whole.Type))
		{
			return Op(OpMatrixTimesScalar, Type, {Whole.Id, Factor.Id});
		}
		if (Whole.Type->IsVector() && Whole.Type->Columns > 1 && IsReal(A->Scalar))
		{
			return Op(OpVectorTimesScalar, Type, {Whole.Id, Factor.Id});
		}
		return Arithmetic("*", Node.Type, Convert(In[0].Id, A, Node.Type), Convert(In[1].Id, B, Node.Type), Node.Type);
	}
	if (!A->IsMatrix() && !B->IsMatrix())
	{
		return Dot(A, In[0].Id, In[1].Id);
	}
	const bool bReal = (!A->IsMatrix() || IsRealMatrix(A)) && (!B->IsMatrix() || IsRealMatrix(B)) &&
					   (!Node.Type->IsMatrix() || IsRealMatrix(Node.Type)) && Node.Type->NumComponents() > 1;
	if (bReal)
	{
		const uint16_t Opcode = !A->IsMatrix()   ? OpMatrixTimesVector
								: !B->IsMatrix() ? OpVectorTimesMatrix
												 : OpMatrixTimesMatrix;
		return Op(Opcode, Type, {In[1].Id, In[0].Id});
	}
	// Row by column, element by element.
	const uint32_t Rows = A->IsMatrix() ? A->Rows : 1;
	const uint32_t Columns = B->IsMatrix() ? B->Columns : 1;
	const uint32_t Inner = A->Columns;
	const FType* const Line = Types.Vector(A->Scalar, Inner);
	std::vector<FPart> Scalars;
	for (uint32_t r = 0; r < Rows; ++r)
	{
		for (uint32_t c = 0; c < Columns; ++c)
		{
			FWords Left;
			FWords Right;
			for (uint32_t k = 0; k < Inner; ++k)
			{
				Left.push_back(Extract(In[0].Id, A, r * Inner + k));
				Right.push_back(Extract(In[1].Id, B, k * Columns + c));
			}
			const uint32_t X = Inner == 1 ? Left[0] : Construct(TypeOf(Line), Left);
			const uint32_t Y = Inner == 1 ? Right[0] : Construct(TypeOf(Line), Right);
			Scalars.push_back({Dot(Line, X, Y), Types.Scalar(A->Scalar)});
		}
	}
	return Build(Node.Type, Scalars);
}

uint32_t FEmitter::AllOrAny(const FValue& Node, const FArguments& In)
{
	const bool bAll = Node.Name == "all";
	const FType* const Bools = Types.WithScalar(In[0].Type, EScalar::Bool);
	const uint32_t Id = Convert(In[0].Id, In[0].Type, Bools);
	const uint32_t Bool = Module.Bool();
	uint32_t Result = 0;
	for (uint32_t r = 0; r < Bools->Rows; ++r)
	{
		const uint32_t Row = Bools->IsMatrix() ? ExtractAt(Id, TypeOf(RowOf(Bools)), {r}) : Id;
		const uint32_t Each = Bools->Columns == 1 ? Row : Op(bAll ? OpAll : OpAny, Bool, {Row});
		Result = r == 0 ? Each : Op(bAll ? OpLogicalAnd : OpLogicalOr, Bool, {Result, Each});
	}
	return Result;
}

uint32_t FEmitter::Transpose(const FValue& Node, const FArguments& In)
{
	const FType* const Of = In[0].Type;
	if (!Of->IsMatrix())
	{
		return In[0].Id;
	}
	if (IsRealMatrix(Of))
	{
		return Op(OpTranspose, TypeOf(Node.Type), {In[0].Id});
	}
	std::vector<FPart> Scalars;
	for (uint32_t c = 0; c < Of->Columns; ++c)
	{
		for (uint32_t r = 0; r < Of->Rows; ++r)
		{
			Scalars.push_back({Extract(In[0].Id, Of, r * Of->Columns + c), Types.Scalar(Of->Scalar)});
		}
	}
	return Build(Node.Type, Scalars);
}

uint32_t FEmitter::Reinterpret(const FValue& Node, const FArguments& In)
{
	if (Node.Name == "asdouble")
	{
		return ByScalars(Node.Type, In,
			[&](const FType* Part, const FWords& Ids)
			{
				const uint32_t Pair = Construct(VectorOf(EScalar::Uint, 2), Ids);
				return Op(OpBitcast, TypeOf(Part), {Pair});
			});
	}
	const FType* const Of = In[0].Type;
	return ByRows(Node.Type, In,
		[&](const FType* Part, const FWords& Ids)
		{ return ScalarType(Part->Scalar) == ScalarType(Of->Scalar) ? Ids[0] : Op(OpBitcast, TypeOf(Part), Ids); });
}

uint32_t FEmitter::Derivative(const FValue& Node, const FArguments& In)
{
	const std::string_view Name = Node.Name;
	const bool bX = Name.starts_with("ddx");
	const bool bCoarse = Name.ends_with("_coarse");
	const bool bFine = Name.ends_with("_fine");
	if (bCoarse || bFine)
	{
		Module.Capability(CapabilityDerivativeControl);
	}
	const uint16_t Opcode = Name == "fwidth" ? OpFwidth
							: bCoarse        ? (bX ? OpDPdxCoarse : OpDPdyCoarse)
							: bFine          ? (bX ? OpDPdxFine : OpDPdyFine)
											 : (bX ? OpDPdx : OpDPdy);
	return ByRows(Node.Type, In,
		[&](const FType* Part, const FWords& Ids)
		{
			const FType* const Real = Types.WithScalar(Part, EScalar::Float);
			return Convert(Op(Opcode, TypeOf(Real), {Convert(Ids[0], Part, Real)}), Real, Part);
		});
}

uint32_t FEmitter::Simple(const FValue& Node, const FArguments& In)
{
	const std::string_view Name = Node.Name;
	const FType* const Of = In.empty() ? Node.Type : In[0].Type;
	if (Name == "CheckAccessFullyMapped")
	{
		return ScalarConstant(EScalar::Bool, 1);
	}
	if (Name == "NonUniformResourceIndex")
	{
		return In[0].Id;
	}
	if (Name == "clip")
	{
		const FType* const Bools = Types.WithScalar(Of, EScalar::Bool);
		const uint32_t Negative = Arithmetic("<", Of, In[0].Id, Module.Null(TypeOf(Of)), Of);
		FValue Any;
		Any.Name = "any";
		If(AllOrAny(Any, {{Negative, Bools}}), [this] { Kill(); });
		return 0;
	}
	if (Name == "determinant")
	{
		return IsRealMatrix(Of) ? Ext(ExtDeterminant, TypeOf(Node.Type), {In[0].Id}) : Extract(In[0].Id, Of, 0);
	}
	if (Name == "select")
	{
		return Of->IsScalar()
				   ? Choose(In[0].Id, Node.Type, In[1].Id, In[2].Id)
				   : ByRows(Node.Type, In,
						 [&](const FType* Part, const FWords& Ids) { return Op(OpSelect, TypeOf(Part), Ids); });
	}
	if (Name == "D3DCOLORtoUBYTE4")
	{
		const uint32_t Turned = Shuffle(In[0].Id, Of->Scalar, 4, {2, 1, 0, 3});
		const uint32_t Scaled = Op(OpVectorTimesScalar, TypeOf(Of), {Turned, RealConstant(Of->Scalar, EmitColorScale)});
		return Convert(Scaled, Of, Node.Type);
	}
	if (Name == "sign")
	{
		const ENumber Kind = KindOf(Of->Scalar);
		const FType* const Bools = Types.WithScalar(Of, EScalar::Bool);
		const uint32_t Id = Kind == ENumber::Unsigned
								? Convert(In[0].Id, Of, Bools)
								: ByRows(Of, In,
									  [&](const FType* Part, const FWords& Ids)
									  { return Ext(Kind == ENumber::Real ? ExtFSign : ExtSSign, TypeOf(Part), Ids); });
		return Convert(Id, Kind == ENumber::Unsigned ? Bools : Of, Node.Type);
	}
	return ByRows(Node.Type, In, [&](const FType* Part, const FWords& Ids) { return Component(Node, Part, Ids); });
}

/** Intrinsics that go by components. Part: of the result. */
uint32_t FEmitter::Component(const FValue& Node, const FType* Part, const FWords& Ids)
{
	const std::string_view Name = Node.Name;
	const uint32_t Type = TypeOf(Part);
	const auto Real = [&](double Value)
	{
		return Splat(RealConstant(Part->Scalar, Value), ScalarType(Part->Scalar), Part->Columns);
	};
	if (Name == "saturate")
	{
		return Ext(ExtNClamp, Type, {Ids[0], Real(0), Real(1)});
	}
	if (Name == "rcp")
	{
		return Op(OpFDiv, Type, {Real(1), Ids[0]});
	}
	if (Name == "log10")
	{
		return Op(OpFMul, Type, {Ext(ExtLog2, Type, Ids), Real(EmitLog10Of2)});
	}
	if (Name == "fmod")
	{
		return Op(OpFRem, Type, Ids);
	}
	if (Name == "ldexp")
	{
		return Op(OpFMul, Type, {Ids[0], Ext(ExtExp2, Type, {Ids[1]})});
	}
	if (Name == "isnan" || Name == "isinf")
	{
		return Op(Name == "isnan" ? OpIsNan : OpIsInf, Type, Ids);
	}
	if (Name == "isfinite")
	{
		const uint32_t Nan = Op(OpIsNan, Type, Ids);
		const uint32_t Inf = Op(OpIsInf, Type, Ids);
		return Op(OpLogicalNot, Type, {Op(OpLogicalOr, Type, {Nan, Inf})});
	}
	if (Name == "and" || Name == "or")
	{
		return Op(Name == "and" ? OpLogicalAnd : OpLogicalOr, Type, Ids);
	}
	Fail(Node.Place, "'" + std::string(Name) + "' does not run on the CPU tier; write it in another way");
}

} // namespace Drydock::Hlsl
