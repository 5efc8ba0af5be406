// Emits samples by gradients, of cubes, with offsets, comparisons and gathers.
#include "SpirvEmitter.h"

#include "SpirvImageOperands.h"

namespace Drydock
{

using namespace Spirv;

/** "g1, g2, " of the texture and the sampler. */
std::string FSpirvEmitter::SampledHandles(const FSpirvInstruction& I) const
{
	const auto Pair = Definitions.find(I.Operands[0]);
	if (Module.GetType(ImageTypeOf(I.Operands[0]).Element).Kind != Float)
	{
		Module.Fail("a texture of integers cannot be filtered; use Load", &I);
	}
	if (Pair == Definitions.end() || Pair->second->Op != OpSampledImage)
	{
		Module.Fail("SPIR-V: a sample without its texture and sampler", &I);
	}
	return HandleOf(Pair->second->Operands[0]) + ", " + HandleOf(Pair->second->Operands[1]) + ", ";
}

/** The mip level of a sample, written before it where it is computed. */
std::string FSpirvEmitter::LevelOf(const FSpirvInstruction& I)
{
	const FSpirvImageOperands Told = GetImageOperands(I);
	std::string Level = UnclampedLevelOf(I, Told);
	if (!Told.MinLod || (!ChoosesLevel(I) && !Told.GradX))
	{
		return Level;
	}
	const std::string Name = "w" + Number(I.Result) + "m";
	Line("const R " + Name + " = ClampLevel(" + HandleOf(Definitions.at(I.Operands[0])->Operands[1]) + ", " + Level +
		 ", " + UseAs(Scalar(I.Operands[Told.MinLod], 0), Float, true) + ");");
	return Name;
}

std::string FSpirvEmitter::UnclampedLevelOf(const FSpirvInstruction& I, const FSpirvImageOperands& Told)
{
	if (Told.Lod)
	{
		return UseAs(Scalar(I.Operands[Told.Lod], 0), Float, false);
	}
	if (ChoosesLevel(I))
	{
		const std::string Chosen = "w" + Number(I.Result) + "l";
		const std::string Bias = Told.Bias ? " + " + UseAs(Scalar(I.Operands[Told.Bias], 0), Float, true) : "";
		Line("const R " + Chosen + " = " + QuadLevelOf(I, "SampleLevelOf") + Bias + ";");
		return Chosen;
	}
	if (!Told.GradX)
	{
		return "Real(0)"; // Sample: the view has one mip, or there are no derivatives
	}
	const uint32_t Dim = ImageTypeOf(I.Operands[0]).Dim;
	const uint32_t Axes = Dim == Dim2D ? 2 : 3;
	const std::string Name = "w" + Number(I.Result) + "l";
	Line("const R " + Name + " = GradientLevel" + (Dim == DimCube ? "Cube(" : "(") +
		 HandleOf(Definitions.at(I.Operands[0])->Operands[0]) + ", " +
		 (Dim == DimCube ? Coordinates(I, 1, Axes, true, 0) + ", " : std::string()) +
		 Coordinates(I, Told.GradX, Axes, true, 0) + ", " + Coordinates(I, Told.GradY, Axes, true, 0) + ");");
	return Name;
}

/** The sampler's place of the instruction: operand of its offset, 0 for none, from that scalar on. */
std::string FSpirvEmitter::SamplePlace(const FSpirvInstruction& I, size_t OffsetOperand, uint32_t FirstOffset)
{
	const FSpirvType& Type = ImageTypeOf(I.Operands[0]);
	const uint32_t Axes = Type.Dim == Dim2D ? 2 : 3;
	const std::string Name = "w" + Number(I.Result);
	std::string Offsets = "nullptr";
	if (OffsetOperand)
	{
		Offsets = Name + "o" + Number(FirstOffset);
		std::string Text = "const I " + Offsets + "[] = {";
		for (uint32_t Axis = 0; Axis < Axes; ++Axis)
		{
			Text += (Axis ? ", " : "") + UseAs(Scalar(I.Operands[OffsetOperand], FirstOffset + Axis), Int, true);
		}
		Line(Text + "};");
	}
	return std::string("MakeSamplePlace<") + (Type.Dim == DimCube ? "true, " : "false, ") +
		   (Type.bArrayed ? "true>(" : "false>(") + Name + "c, " +
		   (IsSpirvComparison(I.Op) ? "&" + Name + "r" : "nullptr") + ", " + Offsets + ")";
}

bool FSpirvEmitter::EmitSample(const FSpirvInstruction& I)
{
	const FSpirvImageOperands Told = GetImageOperands(I);
	const FSpirvType& Type = ImageTypeOf(I.Operands[0]);
	const bool bGather = IsSpirvGather(I.Op);
	if (!bGather && !Told.Reference && !Told.GradX && Type.Dim != DimCube && !Told.Offset && !Told.MinLod)
	{
		return false;
	}
	const std::string Handles = SampledHandles(I);
	const std::string Name = "w" + Number(I.Result);
	const std::string Size = Number((Type.Dim == Dim2D ? 2 : 3) + Type.bArrayed);
	Line("const TVec<R, " + Size + "> " + Name +
		 "c = " + Coordinates(I, 1, (Type.Dim == Dim2D ? 2u : 3u) + Type.bArrayed, true, 0) + ";");
	if (Told.Reference)
	{
		Line("const R " + Name + "r = " + UseAs(Scalar(I.Operands[Told.Reference], 0), Float, true) + ";");
	}
	if (!bGather)
	{
		const std::string LevelText = LevelOf(I);
		Line("const auto " + Name + " = " + (Told.Reference ? "CompareAt<N>(" : "SampleAt<N>(") + Handles +
			 SamplePlace(I, Told.Offset, 0) + ", " + LevelText + ");");
		for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
		{
			Define(I.Result, i, {Told.Reference ? Name : Name + "[" + Number(i) + "]", Float, true, -1});
		}
	}
	else
	{
		const uint32_t Component = Told.Component ? Module.GetConstantScalar(I.Operands[Told.Component]) : 0;
		for (uint32_t k = 0; k < (Told.Offsets ? 4u : 1u); ++k)
		{
			const std::string Place = SamplePlace(I, Told.Offsets ? Told.Offsets : Told.Offset, 2 * k);
			Line("const auto " + Name + "_" + Number(k) + " = GatherAt<N>(" + Handles + Place + ", " +
				 Number(Component) + ");");
		}
		for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
		{
			// Each of four offsets moves its own texel, as in Direct3D; Vulkan takes the upper left one of all.
			const std::string Text = Name + "_" + Number(Told.Offsets ? i : 0) + "[" + Number(i) + "]";
			Define(I.Result, i, {Text, Float, true, -1});
		}
	}
	CountLanes("Samples");
	return true;
}

} // namespace Drydock
