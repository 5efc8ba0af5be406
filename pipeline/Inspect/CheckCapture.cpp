// Looks at what each dispatch stored; of threads whose texels are wrong, or of all, the interpreter finds the line.
#include "Inspect/CheckCapture.h"

#include "PixelFormatConversion.h"
#include "Text/ConfigErrors.h"

#include <cmath>

namespace Drydock
{

std::vector<std::string> GetCheckNames()
{
	std::vector<std::string> Names;
	for (size_t Check = 0; Check < size_t(ECheck::Count); ++Check)
	{
		Names.push_back(GetCheckName(ECheck(Check)));
	}
	return Names;
}

FCheckSet MakeCheckSet(const std::vector<std::string>& Names)
{
	FCheckSet Set;
	for (const std::string& Name : Names)
	{
		bool bKnown = Name == "all";
		for (size_t Check = 0; Check < size_t(ECheck::Count); ++Check)
		{
			const bool bMeant = Name == "all" || Name == GetCheckName(ECheck(Check));
			Set.bOn[Check] = Set.bOn[Check] || bMeant;
			bKnown = bKnown || bMeant;
		}
		if (!bKnown)
		{
			throw BadArgument("there is no check '" + Name + "'" + SuggestName(Name, GetCheckNames()), "--check");
		}
	}
	return Set;
}

FCheckCapture::FCheckCapture(const FCheckSet& InChecks, std::string InPasses)
	: Checks(InChecks)
	, Passes(std::move(InPasses))
{
}

FCheckCapture::~FCheckCapture() = default;

void FCheckCapture::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile&)
{
	const bool bWrites = (!Shader.RWTextures.empty() || !Shader.RWBuffers.empty()) && IsPassNamed(Passes, Shader);
	Before = bWrites ? std::make_unique<FSandbox>(Args, Shader.GetReflection()) : nullptr;
}

bool FCheckCapture::IsSuspect(const double (&Color)[4], ETexelStorage Storage) const
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Storage);
	for (int c = 0; c < Info.NumChannels && c < 4; ++c)
	{
		// A format's denormals and what it rounds to 0 cannot be told from honest zeros: all threads are looked at.
		const bool bNotFinite = !std::isfinite(Color[c]);
		if ((bNotFinite && (Checks[ECheck::NonFinite] || Checks[ECheck::Overflow])) ||
			(c < 3 && Color[c] < 0 && Checks[ECheck::Negative]))
		{
			return true;
		}
	}
	return false;
}

std::vector<std::array<int32_t, 3>> FCheckCapture::FindSuspects(
	const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) const
{
	std::vector<FKernelTexture> Written(Shader.RWTextures);
	for (int32_t Target = 0; Target < Args.NumTargets; ++Target)
	{
		Written.push_back(Args.Targets[Target].Texture);
	}
	std::set<std::array<int32_t, 3>> Found; // z, y, x
	for (const FKernelTexture& Texture : Written)
	{
		if (GetTexelStorageInfo(Texture.Storage).Kind != ETexelKind::Float || Texture.NumMips < 1)
		{
			continue;
		}
		const FKernelMip& Mip = Texture.Mips[0];
		const int32_t Size = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
		for (int32_t z = 0; z < Mip.SizeZ; ++z)
		{
			for (int32_t y = 0; y < Mip.SizeY; ++y)
			{
				for (int32_t x = 0; x < Mip.SizeX; ++x)
				{
					double Color[4];
					DecodeTexel(Texture.Storage,
						Mip.Data + z * Mip.SlicePitch + int64_t(y) * Mip.RowPitch + int64_t(x) * Size, Color);
					if (IsSuspect(Color, Texture.Storage))
					{
						Found.insert({z, y, x});
					}
				}
			}
		}
	}
	std::vector<std::array<int32_t, 3>> Threads;
	for (const auto& [z, y, x] : Found)
	{
		const bool bInside =
			x >= Whole.MinX && y >= Whole.MinY && z >= Whole.MinZ && x < Whole.MaxX && y < Whole.MaxY && z < Whole.MaxZ;
		if (bInside)
		{
			Threads.push_back({x, y, z});
		}
	}
	return Threads;
}

void FCheckCapture::AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	if (!IsPassNamed(Passes, Shader))
	{
		return;
	}
	const bool bAll = Checks.NeedsEveryThread() || Checks[ECheck::Denormal];
	const std::vector<std::array<int32_t, 3>> Suspects =
		bAll ? std::vector<std::array<int32_t, 3>>() : FindSuspects(Shader, Args, Whole);
	if (!bAll && Suspects.empty())
	{
		return;
	}
	const std::shared_ptr<FInspectedShader> Inspected = Shaders.Get(Shader);
	const FKernelArgs& Given = Before ? Before->GetArgs() : Args;
	std::vector<FCheckFinding> Found = CheckThreads(*Inspected, Shader, Given, Whole, Suspects, Checks);
	if (Found.empty() && !bAll && Before)
	{
		Found = CheckThreads(*Inspected, Shader, Given, Whole, {}, Checks); // threads that store elsewhere
	}
	for (FCheckFinding& Finding : Found)
	{
		Findings.push_back({GetPassName(Shader), Shader.Name, std::move(Finding), FIntPoint(Whole.MaxX, Whole.MaxY)});
	}
}

std::vector<FDiagnostic> FCheckCapture::GetDiagnostics() const
{
	std::vector<FDiagnostic> Diagnostics;
	for (const FPassFinding& Found : Findings)
	{
		const FCheckFinding& Finding = Found.Finding;
		const std::string Times =
			Finding.Threads == 1 ? std::string("at (") : "first of " + std::to_string(Finding.Threads) + " at (";
		Diagnostics.push_back({ESeverity::Warning, WarnCheck,
			std::string(GetCheckName(Finding.Check)) + ": " + Finding.What + ", " + Times +
				std::to_string(Finding.First[0]) + ", " + std::to_string(Finding.First[1]) + ")" +
				(Finding.Source.empty() ? std::string() : ": " + Finding.Source),
			Finding.File, Finding.Line, 0, "pass " + Found.Pass + ", " + Found.Shader});
	}
	return Diagnostics;
}

} // namespace Drydock
