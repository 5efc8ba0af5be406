// Runs what the four pixels of a quad do together: derivatives, and samples that choose their level by them. The same
// rules as in LanesQuads.h.
#pragma once

#include "SpirvImageOperands.h"
#include "SpirvThread.h"

#include "Lanes.h"
#include "LanesLevels.h"
#include "LanesLod.h"

namespace Drydock
{

using namespace Spirv;

/** A pixel that is run again alone ends here: what it does as a helper is nobody's to see. */
template<typename Real>
void TSpirvThread<Real>::Discard()
{
	bDemoted = Program.Module.bQuads && !bReplay;
	bDiscarded = !bDemoted;
	bHelper = bHelper || bDemoted;
}

template<typename Real>
void TSpirvThread<Real>::ExecuteQuad(const std::vector<TSpirvThread*>& Together)
{
	const FSpirvStep& Step = Together.front()->GetWaiting();
	const uint16_t Op = Step.I->Op;
	const TSpirvThread* Quad[4] = {}; // first row, second row
	for (const TSpirvThread* const Thread : Together)
	{
		Quad[Thread->Lane & 3] = Thread;
	}
	const auto Difference = [&](uint32_t A, uint32_t B, size_t Operand, uint32_t Index)
	{
		const bool bBoth = Quad[A] && Quad[B];
		return bBoth ? Quad[B]->GetValue(Step, Operand, Index) - Quad[A]->GetValue(Step, Operand, Index) : Real(0);
	};
	using FVector = Lanes::TVec<Real, 3>;
	using FFlat = Lanes::TVec<Real, 2>;
	const auto GetLevelOf = [&](const FKernelTexture& Texture, const TSpirvThread& Thread, uint32_t Dim)
	{
		const auto Along = [&](uint32_t Other, uint32_t i)
		{
			return Difference(0, Other, 1, i);
		};
		if (Dim == Dim2D)
		{
			return Lanes::GradientLevel(Texture, FFlat(Along(1, 0), Along(1, 1)), FFlat(Along(2, 0), Along(2, 1)));
		}
		const FVector X(Along(1, 0), Along(1, 1), Along(1, 2));
		const FVector Y(Along(2, 0), Along(2, 1), Along(2, 2));
		const FVector At(Thread.GetValue(Step, 1, 0), Thread.GetValue(Step, 1, 1), Thread.GetValue(Step, 1, 2));
		return Dim == DimCube ? Lanes::GradientLevelCube(Texture, At, X, Y) : Lanes::GradientLevel(Texture, X, Y);
	};
	for (TSpirvThread* const Thread : Together)
	{
		if (!ChoosesSpirvLevel(Op) && Op != OpImageQueryLod)
		{
			const bool bFine = Op >= OpDPdxFine && Op <= OpFwidthFine;
			const uint32_t Row = bFine ? Thread->Lane & 2 : 0;
			const uint32_t Column = bFine ? Thread->Lane & 1 : 0;
			for (uint32_t i = 0; i < Step.Size; ++i)
			{
				const Real X = Difference(Row, Row + 1, 0, i);
				const Real Y = Difference(Column, Column + 2, 0, i);
				const int Kind = (Op - OpDPdx) % 3; // along x, along y, the sum
				Thread->Result(Step)[i] = ToSpirvWord<Real>(Kind == 0   ? X
															: Kind == 1 ? Y
																		: Lanes::Abs(X) + Lanes::Abs(Y));
			}
			Thread->Note(Step);
			Thread->ShowWaiting();
			continue;
		}
		const FKernelTexture& Texture = Thread->ViewOf(Thread->Args->Textures, Thread->Bits(Step, 0, 0));
		const FSpirvType& Pair = Thread->Program.Module.GetValueType(Step.I->Operands[0]);
		const uint32_t Dim = Thread->Program.Module.GetType(Pair.Element).Dim;
		const bool bNoChoice = Op != OpImageQueryLod && Texture.NumMips < 2;
		const Real Found = bNoChoice ? Real(0) : GetLevelOf(Texture, *Thread, Dim);
		if (Op == OpImageQueryLod)
		{
			const FKernelSampler& Sampler = Thread->ViewOf(Thread->Args->Samplers, Thread->Bits(Step, 0, 1));
			const auto Levels = Lanes::DescribeLevel(Texture, Sampler, Found);
			for (uint32_t i = 0; i < Step.Size; ++i)
			{
				Thread->Result(Step)[i] = ToSpirvWord<Real>(Levels.E[i]);
			}
			Thread->Note(Step);
		}
		else
		{
			const FSpirvImageOperands Told = GetImageOperands(*Step.I);
			Thread->Level =
				Thread->ClampLevel(Step, Told, Told.Bias ? Found + Thread->GetValue(Step, Told.Bias, 0) : Found);
			if (Thread->Log)
			{
				Thread->Log->push_back(ToSpirvWord<Real>(Thread->Level));
			}
			Thread->Execute(Step);
		}
		Thread->ShowWaiting();
	}
}

} // namespace Drydock
