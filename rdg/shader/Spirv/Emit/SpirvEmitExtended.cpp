// Emits the functions of GLSL.std.450 that work on whole vectors, pack numbers or have two results.
#include "SpirvEmitter.h"

namespace Drydock
{

using namespace Spirv;

std::string FSpirvEmitter::DeterminantText(uint32_t Matrix, ESpirvType Kind, bool bVarying)
{
	const uint32_t Size = Module.GetValueType(Matrix).Count;
	const std::string Column = "TVec<" + TypeName(Kind, bVarying) + ", " + Number(Size) + ">(";
	std::string Columns;
	for (uint32_t c = 0; c < Size; ++c)
	{
		Columns += (c ? ", " : "") + Column;
		for (uint32_t r = 0; r < Size; ++r)
		{
			Columns += (r ? ", " : "") + UseAs(Scalar(Matrix, c * Size + r), Kind, bVarying);
		}
		Columns += ")";
	}
	const std::string Dimensions = Number(Size) + ", " + Number(Size);
	return "Determinant(TMat<" + TypeName(Kind, bVarying) + ", " + Dimensions + ">(" + Columns + "))";
}

/** A double made of its halves, and two numbers made of one. */
void FSpirvEmitter::EmitPacking(const FSpirvInstruction& I, bool bVarying)
{
	const auto Part = [this, &I, bVarying](uint32_t Index)
	{
		return UseAs(Scalar(I.Operands[2], Index), Uint, bVarying);
	};
	if (I.Operands[1] == ExtPackDouble2x32)
	{
		Define(I.Result, 0,
			{"DoubleOfBits(AsUlong(" + Part(0) + ") | ShiftLeft(AsUlong(" + Part(1) + "), uint64_t(32)))",
				ESpirvType::Double, bVarying, -1});
		return;
	}
	const std::string Temporary = "w" + Number(I.Result);
	const bool bHalf = I.Operands[1] == ExtUnpackHalf2x16;
	if (bHalf)
	{
		Line("const auto " + Temporary + " = UnpackHalf2<Real>(" + Part(0) + ");");
	}
	for (uint32_t i = 0; i < 2; ++i)
	{
		const std::string Bits = bHalf ? "" : "DoubleBits(" + Use(Scalar(I.Operands[2], 0)) + ")";
		const std::string Text = bHalf ? Temporary + "[" + Number(i) + "]"
								 : i   ? "AsUint(ShiftRight(" + Bits + ", uint64_t(32)))"
									   : "AsUint(" + Bits + ")";
		Define(I.Result, i, {Text, bHalf ? Float : Uint, bVarying, -1});
	}
}

void FSpirvEmitter::EmitLdexp(const FSpirvInstruction& I, ESpirvType Kind)
{
	for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
	{
		// HLSL's exponent is a float: x * 2^exponent.
		const FEmitScalar Value = Scalar(I.Operands[2], i);
		const FEmitScalar Exponent = Scalar(I.Operands[3], i);
		const bool bVarying = Value.bVarying || Exponent.bVarying;
		const std::string Text = Exponent.Kind == Float ? Use(Value) + " * Exp2(" + Use(Exponent) + ")"
														: "Ldexp(" + UseAs(Value, Kind, bVarying) + ", " +
															  UseAs(Exponent, Int, bVarying) + ")";
		Define(I.Result, i, {WithDenormals(Kind, Text), Kind, bVarying, -1});
	}
}

/** Source: GLSL.std.450, whose round() is to the nearest even here. */
void FSpirvEmitter::EmitNorms(const FSpirvInstruction& I, const FSpirvNorms& Norms, bool bVarying)
{
	const std::string One = "Real(" + Number(Norms.GetOne()) + ")";
	const std::string Least = Norms.bSigned ? "Real(-1)" : "Real(0)";
	std::string Packed;
	OperandLevel = EEmitLevel::Tile;
	for (uint32_t i = 0; i < Norms.Count; ++i)
	{
		const std::string Shift = Number(i * Norms.GetBits());
		if (Norms.bPacks)
		{
			const std::string Code = "ToInt(RoundEven(Clamp(" + UseAs(Scalar(I.Operands[2], i), Float, bVarying) +
									 ", " + Least + ", Real(1)) * " + One + "))";
			const std::string Mask = Number(uint32_t((uint64_t(1) << Norms.GetBits()) - 1)) + "u";
			Packed += (i ? " | " : "") + ("ShiftLeft(AsUint(" + Code + ") & " + Mask + ", " + Shift + ")");
			continue;
		}
		const std::string Code = std::string("BitFieldExtract(") +
								 UseAs(Scalar(I.Operands[2], 0), Norms.bSigned ? Int : Uint, bVarying) + ", " + Shift +
								 "u, " + Number(Norms.GetBits()) + "u)";
		Define(I.Result, i, {"Max(ToReal<Real>(" + Code + ") / " + One + ", " + Least + ")", Float, bVarying, -1});
	}
	if (Norms.bPacks)
	{
		Define(I.Result, 0, {Packed, Uint, bVarying, -1});
	}
}

void FSpirvEmitter::EmitFrexp(const FSpirvInstruction& I, ESpirvType Kind)
{
	for (uint32_t i = 0; i < SizeOf(I.Operands[2]); ++i)
	{
		const FEmitScalar Value = Scalar(I.Operands[2], i);
		const std::string Temporary = "w" + Number(I.Result) + "_" + Number(i);
		Line("const auto " + Temporary + " = " + WithDenormals(Kind, "Frexp(" + Use(Value) + ")") + ";");
		Define(I.Result, i, {Temporary + "[0]", Kind, Value.bVarying, -1});
		Define(I.Result, SizeOf(I.Operands[2]) + i, {"ToInt(" + Temporary + "[1])", Int, Value.bVarying, -1});
	}
}

void FSpirvEmitter::EmitModf(const FSpirvInstruction& I, ESpirvType Kind)
{
	std::vector<FEmitScalar> Whole;
	const uint32_t Size = SizeOf(I.Operands[2]);
	for (uint32_t i = 0; i < Size; ++i)
	{
		const FEmitScalar Value = Scalar(I.Operands[2], i);
		const std::string Text = Use(Value);
		Define(I.Result, i, {WithDenormals(Kind, Text + " - Trunc(" + Text + ")"), Kind, Value.bVarying, -1});
		Whole.push_back({"Trunc(" + Text + ")", Kind, Value.bVarying, -1});
	}
	for (uint32_t i = 0; i < Size && I.Operands[1] == ExtModfStruct; ++i)
	{
		Define(I.Result, Size + i, Whole[i]);
	}
	if (I.Operands[1] == ExtModf)
	{
		EmitStore(I.Operands[3], Whole, I);
	}
}

void FSpirvEmitter::EmitExtended(const FSpirvInstruction& I)
{
	const uint32_t Ext = I.Operands[1];
	const ESpirvType Real = Scalar(I.Operands[2], 0).Kind == ESpirvType::Double ? ESpirvType::Double : Float;
	bool bVarying = false;
	for (size_t k = 2; k < I.Operands.size() && Ext != ExtModf; ++k)
	{
		bVarying = bVarying || Uniformity.IsAnyVarying(I.Operands[k]);
		for (uint32_t i = 0; i < SizeOf(I.Operands[k]); ++i)
		{
			bVarying = bVarying || Scalar(I.Operands[k], i).bVarying;
		}
	}
	// A vector of the lanes' own, for functions that work on the whole of it.
	const auto Vector = [this, &I, Real, bVarying](size_t Operand)
	{
		const uint32_t Id = I.Operands[Operand];
		const uint32_t Size = SizeOf(Id);
		std::string Text;
		for (uint32_t i = 0; i < Size; ++i)
		{
			Text += (i ? ", " : "") + UseAs(Scalar(Id, i), Real, bVarying);
		}
		return Size == 1 ? Text : "TVec<" + TypeName(Real, bVarying) + ", " + std::to_string(Size) + ">(" + Text + ")";
	};
	const std::string Temporary = "w" + std::to_string(I.Result);
	const auto DefineComponents = [this, &I, &Temporary, Real, bVarying](const std::string& Expression)
	{
		const uint32_t Size = SizeOf(I.Result);
		Line("const auto " + Temporary + " = " + WithDenormals(Real, Expression) + ";");
		for (uint32_t i = 0; i < Size; ++i)
		{
			Define(
				I.Result, i, {Size == 1 ? Temporary : Temporary + "[" + std::to_string(i) + "]", Real, bVarying, -1});
		}
	};
	const bool bScalar = SizeOf(I.Operands[2]) == 1;
	if (const FSpirvNorms* const Norms = FindSpirvNorms(Ext))
	{
		EmitNorms(I, *Norms, bVarying);
		return;
	}
	switch (Ext)
	{
	case ExtLength:
		DefineComponents((bScalar ? "Abs(" : "Length(") + Vector(2) + ")");
		break;
	case ExtDistance:
		DefineComponents(
			bScalar ? "Abs(" + Vector(2) + " - " + Vector(3) + ")" : "Distance(" + Vector(2) + ", " + Vector(3) + ")");
		break;
	case ExtCross:
		DefineComponents("Cross(" + Vector(2) + ", " + Vector(3) + ")");
		break;
	case ExtNormalize:
		DefineComponents(bScalar ? "Sign(" + Vector(2) + ")" : "Normalize(" + Vector(2) + ")");
		break;
	case ExtReflect:
	case ExtRefract:
	case ExtFaceForward:
		if (bScalar)
		{
			Module.Fail("reflect, refract and faceforward want vectors on the CPU tier", &I);
		}
		DefineComponents(Ext == ExtReflect   ? "Reflect(" + Vector(2) + ", " + Vector(3) + ")"
						 : Ext == ExtRefract ? "Refract(" + Vector(2) + ", " + Vector(3) + ", " + Vector(4) + ")"
											 : "FaceForward(" + Vector(2) + ", " + Vector(3) + ", " + Vector(4) + ")");
		break;
	case ExtDeterminant:
		DefineComponents(DeterminantText(I.Operands[2], Real, bVarying));
		break;
	case ExtPackDouble2x32:
	case ExtUnpackDouble2x32:
	case ExtUnpackHalf2x16:
		EmitPacking(I, bVarying);
		break;
	case ExtPackHalf2x16:
		Define(I.Result, 0, {"PackHalf2(" + Vector(2) + ")", Uint, bVarying, -1});
		break;
	case ExtLdexp:
		EmitLdexp(I, Real);
		break;
	case ExtFrexpStruct:
		EmitFrexp(I, Real);
		break;
	case ExtModf:
	case ExtModfStruct:
		EmitModf(I, Real);
		break;
	default:
		Module.Fail("GLSL.std.450 instruction " + std::to_string(Ext) + " is not supported on the CPU tier", &I);
	}
}

} // namespace Drydock
