// Emits what concerns textures and typed buffers: samples, loads, stores and sizes.
#include "SpirvEmitter.h"

#include "SpirvImageOperands.h"

namespace Drydock
{

using namespace Spirv;

std::string FSpirvEmitter::HandleOf(uint32_t Id) const
{
	for (int Steps = 0; Steps < 8; ++Steps)
	{
		if (Module.FindVariable(Id))
		{
			return "g" + Number(Id);
		}
		const auto Found = Definitions.find(Id);
		if (Found == Definitions.end() || Found->second->Operands.empty())
		{
			break;
		}
		Id = Found->second->Operands[0];
	}
	Module.Fail("SPIR-V: a texture or sampler that is not a variable");
}

const FSpirvType& FSpirvEmitter::ImageTypeOf(uint32_t Id) const
{
	const FSpirvType& Type = Module.GetValueType(Id);
	return Type.Kind == ESpirvType::SampledImage ? Module.GetType(Type.Element) : Type;
}

std::string FSpirvEmitter::Coordinates(
	const FSpirvInstruction& I, size_t Operand, uint32_t Count, bool bReal, size_t OffsetOperand)
{
	std::string Text = std::string("TVec<") + (bReal ? "R" : "I") + ", " + Number(Count) + ">(";
	for (uint32_t i = 0; i < Count; ++i)
	{
		Text += (i ? ", " : "") + UseAs(Scalar(I.Operands[Operand], i), bReal ? Float : Int, true);
		if (OffsetOperand && i < SizeOf(I.Operands[OffsetOperand]))
		{
			Text += " + " + UseAs(Scalar(I.Operands[OffsetOperand], i), Int, true);
		}
	}
	return Text + ")";
}

/** The arguments ", Tap, bLearn, X0, Y" of a sample or load with coordinates in operand 1, at a level that may be 0 for
 *  none; empty: it may fall anywhere. */
std::string FSpirvEmitter::TapOf(const FSpirvInstruction& I, uint32_t Level)
{
	constexpr uint32_t MaxTurns = 64;
	constexpr uint32_t MaxTaps = 1024;
	const FSpirvType& Type = ImageTypeOf(I.Operands[0]);
	const bool bStill = (Dependence.Get(I.Operands[1], 0) & ~DependsOnColumn) == 0 &&
						(Dependence.Get(I.Operands[1], 1) & ~DependsOnRow) == 0 &&
						(!Level || (Dependence.GetAll(Level) == 0 && !Scalar(Level, 0).bVarying)) &&
						Dependence.IsSteady(CurrentBlock);
	const uint32_t Turns = Loops.empty() ? 1 : MaxTurns;
	if (bGroups || Module.bQuads || !bStill || Type.Dim != Dim2D || Type.bArrayed ||
		Module.GetType(Type.Element).Kind != Float || NumTaps + Turns > MaxTaps)
	{
		return {};
	}
	std::string Tap = "Taps + " + Number(NumTaps);
	if (!Loops.empty())
	{
		const std::string Turn = "n" + Number(I.Result);
		Declare("uint32_t", Turn, 0, " = 0");
		Line("FKernelTap* const t" + Number(I.Result) + " = " + Turn + " < " + Number(Turns) + "u ? " + Tap + " + " +
			 Turn + " : nullptr;");
		Line("++" + Turn + ";");
		Tap = "t" + Number(I.Result);
	}
	NumTaps += Turns;
	return ", " + Tap + ", bStill && AllLanes(e), X0, Y";
}

/** A sample or load with a tap; Kind: of its coordinates. */
void FSpirvEmitter::EmitTap(
	const FSpirvInstruction& I, const std::string& Handles, ESpirvType Kind, const std::string& Rest)
{
	const std::string Name = "w" + Number(I.Result) + "_";
	const std::string Channels = Name + "0, " + Name + "1, " + Name + "2, " + Name + "3";
	Line("R " + Channels + ";");
	// The first few read whole texels in place; the compiler takes longer for it.
	constexpr uint32_t MaxInline = 4;
	const std::string Arguments = std::string(++NumTapSites <= MaxInline ? "<true" : "<false") + ", Real, N>({";
	Line((Kind == Float ? "SampleLevel2D" : "Load2D") + Arguments + Channels + "}, " + Handles +
		 UseAs(Scalar(I.Operands[1], 0), Kind, true) + ", " + UseAs(Scalar(I.Operands[1], 1), Kind, true) + ", " +
		 Rest + ");");
	for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
	{
		Define(I.Result, i, {Name + Number(i), Float, true, -1});
	}
}

/** Interpolated inputs depend on what FSpirvDependence says. */
std::string FSpirvEmitter::StillText() const
{
	std::string Text;
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (Variable.Storage == StorageInput && Variable.BuiltIn == BuiltInNone)
		{
			Text += std::string(Text.empty() ? "" : " && ") + "IsStill(Args.Interpolants[" +
					std::to_string(GetInterpolantIndex(Variable)) + "], " +
					Number(Module.GetType(Variable.Type).NumScalars) + ")";
		}
	}
	return Text.empty() ? "true" : Text;
}

void FSpirvEmitter::DefineParts(
	const FSpirvInstruction& I, const std::string& Expression, ESpirvType Kind, bool bVarying)
{
	const std::string Name = "w" + Number(I.Result);
	Line("const auto " + Name + " = " + Expression + ";");
	for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
	{
		Define(I.Result, i, {Name + "[" + Number(i) + "]", Kind, bVarying, -1});
	}
}

void FSpirvEmitter::CountLanes(const std::string& Counter)
{
	Line("CountLanesOf(Args, &FKernelCounters::" + Counter + ", " + GetStoreMask() + ");");
}

void FSpirvEmitter::EmitPlainSample(const FSpirvInstruction& I)
{
	const FSpirvType& Type = ImageTypeOf(I.Operands[0]);
	const FSpirvImageOperands Told = GetImageOperands(I);
	const std::string Handles = SampledHandles(I);
	const std::string Level = LevelOf(I);
	const bool b3D = Type.Dim == Dim3D;
	const std::string Place = Coordinates(I, 1, b3D || Type.bArrayed ? 3 : 2, true, 0);
	const char* const Function = b3D ? "SampleLevel3D(" : Type.bArrayed ? "SampleLevel2DArray(" : "SampleLevel2D(";
	const std::string Tap = TapOf(I, Told.Lod ? I.Operands[Told.Lod] : 0);
	if (Tap.empty())
	{
		DefineParts(I, Function + Handles + Place + ", " + Level + ")", Float, true);
	}
	else
	{
		EmitTap(I, Handles, Float, Level + Tap);
	}
	CountLanes("Samples");
}

void FSpirvEmitter::EmitImageLoad(const FSpirvInstruction& I)
{
	const FSpirvType& Type = ImageTypeOf(I.Operands[0]);
	const bool bInteger = Module.GetType(Type.Element).Kind != Float;
	const ESpirvType Kind = bInteger ? Uint : Float;
	const std::string Handle = HandleOf(I.Operands[0]);
	const std::string Suffix = std::string(bInteger ? "Uint" : "") + "<Real, N>(" + Handle + ", ";
	if (Type.Dim == DimBuffer)
	{
		DefineParts(I, "LoadTyped" + Suffix + UseAs(Scalar(I.Operands[1], 0), Uint, true) + ")", Kind, true);
		CountLanes("Loads");
		return;
	}
	const uint32_t Mask = I.Operands.size() > 2 ? I.Operands[2] : 0;
	size_t Next = 3;
	uint32_t MipId = 0;
	std::string Mip = "int32_t(0)";
	if (Mask & ImageLod)
	{
		MipId = I.Operands[Next++];
		Mip = UseAs(Scalar(MipId, 0), Int, false);
	}
	const size_t Offset = Mask & (ImageConstOffset | ImageOffset) ? Next : 0;
	const bool b3D = Type.Dim == Dim3D;
	const std::string Function = b3D ? "Load3D" : Type.bArrayed ? "Load2DArray" : "Load2D";
	const std::string Place = Coordinates(I, 1, b3D || Type.bArrayed ? 3 : 2, false, Offset);
	// Integers have no taps, and a texture that a shader also writes has none either.
	const std::string Tap = Offset || I.Op == OpImageRead ? std::string() : TapOf(I, MipId);
	if (Tap.empty())
	{
		DefineParts(I, Function + Suffix + Place + ", " + Mip + ")", Kind, true);
	}
	else
	{
		EmitTap(I, Handle + ", ", Int, Mip + Tap);
	}
	CountLanes("Loads");
}

void FSpirvEmitter::EmitImageStore(const FSpirvInstruction& I)
{
	const FSpirvType& Type = ImageTypeOf(I.Operands[0]);
	const bool bInteger = Module.GetType(Type.Element).Kind != Float;
	const ESpirvType Kind = bInteger ? Uint : Float;
	std::string Value = std::string("TVec<") + TypeName(Kind, true) + ", 4>(";
	for (uint32_t i = 0; i < 4; ++i)
	{
		const FEmitScalar Part = i < SizeOf(I.Operands[2]) ? Scalar(I.Operands[2], i) : Literal(Kind, 0);
		Value += (i ? ", " : "") + UseAs(Part, Kind, true);
	}
	const bool bBuffer = Type.Dim == DimBuffer;
	const bool b3D = Type.Dim == Dim3D;
	const std::string Function = bBuffer         ? "StoreTyped"
								 : b3D           ? "StoreTexture3D"
								 : Type.bArrayed ? "StoreTexture2DArray"
												 : "StoreTexture2D";
	const std::string Place = bBuffer ? UseAs(Scalar(I.Operands[1], 0), Uint, true)
									  : Coordinates(I, 1, b3D || Type.bArrayed ? 3 : 2, false, 0);
	Line(Function + (bInteger ? "Uint<Real, N>" : "") + "(" + GetStoreMask() + ", " + HandleOf(I.Operands[0]) + ", " +
		 Place + ", " + Value + "));");
	CountLanes("Stores");
}

void FSpirvEmitter::EmitImageSize(const FSpirvInstruction& I)
{
	const FSpirvType& Type = ImageTypeOf(I.Operands[0]);
	const std::string Handle = HandleOf(I.Operands[0]);
	if (Type.Dim == DimBuffer)
	{
		Define(I.Result, 0, {"BufferElements(" + Handle + ")", Uint, false, -1});
		return;
	}
	std::string Mip = "0";
	if (I.Op == OpImageQuerySizeLod)
	{
		const FEmitScalar Level = Scalar(I.Operands[1], 0);
		if (Level.bVarying)
		{
			Module.Fail("GetDimensions wants a mip level that is the same for all threads on the CPU tier", &I);
		}
		Mip = UseAs(Level, Int, false);
	}
	const char* const Function = SizeOf(I.Result) != 3 ? "TextureSize2D("
								 : Type.Dim == DimCube ? "TextureSizeCubes("
													   : "TextureSize3D(";
	DefineParts(I, Function + Handle + ", " + Mip + ")", Int, false);
}

bool FSpirvEmitter::EmitImage(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpSampledImage:
	case OpImage:
		return true; // resolved where it is used
	case OpImageSampleImplicitLod:
	case OpImageSampleExplicitLod:
	case OpImageSampleDrefImplicitLod:
	case OpImageSampleDrefExplicitLod:
	case OpImageGather:
	case OpImageDrefGather:
		if (!EmitSample(I))
		{
			EmitPlainSample(I);
		}
		return true;
	case OpImageFetch:
	case OpImageRead:
		EmitImageLoad(I);
		return true;
	case OpImageWrite:
		EmitImageStore(I);
		return true;
	case OpImageQuerySize:
	case OpImageQuerySizeLod:
		EmitImageSize(I);
		return true;
	case OpImageQueryLevels:
		Define(I.Result, 0, {"TextureLevels(" + HandleOf(I.Operands[0]) + ")", Int, false, -1});
		return true;
	default:
		return false;
	}
}

} // namespace Drydock
