// Looks at what each dispatch stored; of threads whose texels are wrong, or of all, the interpreter finds the line.
#include "Inspect/CheckCapture.h"

#include "PixelFormatConversion.h"
#include "Inspect/StatedFindings.h"
#include "RunningCode.h"
#include "ShaderDirectories.h"
#include "Text/ConfigErrors.h"
#include "ThreadRuns.h"

#include <algorithm>

#include <cmath>
#include <tuple>

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

namespace
{

constexpr size_t MostOfPlugin = 32768;
constexpr size_t MostOfOwn = 4096;
const std::vector<std::array<int32_t, 3>> NoThreads;

} // namespace

/** A file of an overlay is not drydock's own. */
bool FCheckCapture::IsStated(const FCheckFinding& Finding) const
{
	const std::string OnDisk = FindShaderFile(Finding.File);
	const bool bOverlaid = std::ranges::any_of(
		GetShaderOverlays(), [&](const std::string& Folder) { return OnDisk.starts_with(Folder + "/"); });
	return !bOverlaid && !Finding.File.starts_with("/Plugin/") &&
		   std::ranges::any_of(StatedFindings,
			   [&](const FStatedFinding& Stated)
			   {
				   return Finding.File.ends_with(std::string("/") + Stated.File) &&
						  std::string(Stated.Check) == GetCheckName(Finding.Check);
			   });
}

FCheckCapture::FCheckCapture(const FCheckSet& InChecks, FCheckScope InScope)
	: Checks(InChecks)
	, Scope(std::move(InScope))
{
}

FCheckCapture::~FCheckCapture() = default;

void FCheckCapture::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile&)
{
	const bool bWrites = (!Shader.RWTextures.empty() || !Shader.RWBuffers.empty()) && IsPassNamed(Scope.Passes, Shader);
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
	if (!IsPassNamed(Scope.Passes, Shader))
	{
		return;
	}
	const bool bForeign = IsForeignCodeRunning();
	const bool bAll =
		Checks.NeedsEveryThread() || Checks[ECheck::Denormal] || (Scope.bHidden && Checks[ECheck::NonFinite]);
	const size_t Most = bForeign ? MostOfPlugin : MostOfOwn;
	std::vector<std::array<int32_t, 3>> Suspects =
		bAll && !Scope.bAllThreads ? SampleThreads(Whole, Shader.GetReflection(), Most) : NoThreads;
	if (!bAll || !Suspects.empty())
	{
		const std::vector<std::array<int32_t, 3>> Wrong = FindSuspects(Shader, Args, Whole);
		const size_t Every = bAll ? Wrong.size() / Most + 1 : 1;
		for (size_t Index = 0; Index < Wrong.size(); Index += Every)
		{
			Suspects.push_back(Wrong[Index]);
		}
		const auto ByRows = [](const std::array<int32_t, 3>& At)
		{
			return std::tuple(At[2], At[1], At[0]);
		};
		std::ranges::sort(Suspects, {}, ByRows);
		Suspects.erase(std::unique(Suspects.begin(), Suspects.end()), Suspects.end());
	}
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
	const uint64_t Total =
		uint64_t(Whole.MaxX - Whole.MinX) * uint64_t(Whole.MaxY - Whole.MinY) * uint64_t(Whole.MaxZ - Whole.MinZ);
	for (FCheckFinding& Finding : Found)
	{
		if (Scope.bStated || !IsStated(Finding))
		{
			Findings.push_back({GetPassName(Shader), Shader.Name, std::move(Finding), FIntPoint(Whole.MaxX, Whole.MaxY),
				bForeign, bAll && !Suspects.empty() ? Suspects.size() : Total, Total});
		}
	}
}

std::vector<FDiagnostic> FCheckCapture::GetDiagnostics() const
{
	std::vector<FDiagnostic> Diagnostics;
	std::vector<FPassFinding> Sorted = Findings;
	std::ranges::stable_partition(Sorted, &FPassFinding::bForeign);
	for (const FPassFinding& Found : Sorted)
	{
		const FCheckFinding& Finding = Found.Finding;
		const std::string Sample = Found.Looked < Found.Total ? " of " + std::to_string(Found.Looked) + " threads of " +
																	std::to_string(Found.Total)
															  : std::string();
		const std::string Times = Finding.Threads == 1
									  ? std::string("at (")
									  : "first of " + std::to_string(Finding.Threads) + Sample + " at (";
		Diagnostics.push_back({ESeverity::Warning, WarnCheck,
			std::string(GetCheckName(Finding.Check)) + ": " + Finding.What + ", " + Times +
				std::to_string(Finding.First[0]) + ", " + std::to_string(Finding.First[1]) + ")" +
				(Finding.Source.empty() ? std::string() : ": " + Finding.Source),
			Finding.File, Finding.Line, 0, "pass " + Found.Pass + ", " + Found.Shader});
	}
	return Diagnostics;
}

} // namespace Drydock
