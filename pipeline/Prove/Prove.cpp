// Runs pairs of frames and looks for the first pass that tells them apart.
#include "Prove/Prove.h"

#include "DispatchReuse.h"
#include "Prove/PassRecord.h"
#include "Prove/PassTransform.h"
#include "Run/Run.h"
#include "Run/RunErrors.h"
#include "Text/ConfigErrors.h"
#include "Text/GlobPattern.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

const char* const RepeatName = "SecondRun";

bool Clobbers(const FEquivalenceRun& Run)
{
	return std::ranges::any_of(
		Run.Variables, [](const std::string& Variable) { return Variable.starts_with("r.RDG.ClobberResources="); });
}

std::string JoinMessages(const FError& Error)
{
	std::string Text;
	for (const FDiagnostic& Diagnostic : Error.GetDiagnostics())
	{
		Text += Diagnostic.Severity == ESeverity::Error ? (Text.empty() ? "" : "; ") + Diagnostic.ToString() : "";
	}
	return Text;
}

uint64_t CountRounded(const FPicture& Base, const FPicture& Other)
{
	const FImage A = Base.ToImage(), B = Other.ToImage();
	uint64_t Count = 0;
	for (size_t Index = 0; Index < A.Values.size(); ++Index)
	{
		Count += std::memcmp(&A.Values[Index], &B.Values[Index], sizeof(double)) == 0 ? 0 : 1;
	}
	return Count;
}

class FProver
{
public:
	explicit FProver(const FRunOptions& InOptions)
		: Options(InOptions)
		, Plain(RunConfig(InOptions))
		, View(FindPictureView(Plain))
	{
		Bases.push_back({{}, Plain.Final});
	}

	FProven Prove(const FEquivalence& Equivalence)
	{
		FProven Proven;
		Proven.Equivalence = &Equivalence;
		if (Equivalence.Base.Layout != EViewLayout::AsConfigured && (Plain.Views.size() > 1 || View[2] - View[0] < 2))
		{
			Proven.NotRun = Plain.Views.size() > 1 ? "the config has several views" : "the picture cannot be halved";
			return Proven;
		}
		if (Equivalence.Transform != EPassTransform::None)
		{
			FPassTransform Transform(Equivalence.Transform);
			const FScopedDispatchObserver Scope(Transform);
			RunConfig(Options);
			Proven.FirstPass = Transform.GetDifference();
			return Proven;
		}
		for (const FDiagnostic& Diagnostic : Plain.Diagnostics)
		{
			const bool bTold = Equivalence.Name == RepeatName && Diagnostic.Code == WarnUnwrittenRead;
			Proven.Unwritten +=
				bTold ? (Proven.Unwritten.empty() ? "" : "; ") + Diagnostic.Where + ": " + Diagnostic.Message : "";
		}
		FPicture Base;
		try
		{
			Base = GetBase(Equivalence.Base);
		}
		catch (const FError& Error)
		{
			Proven.NotRun = JoinMessages(Error);
			return Proven;
		}
		try
		{
			Compare(Base, Crop(RunFinal(Equivalence.Other), Equivalence.Other), Proven);
			if (Proven.Final)
			{
				FindFirstPass(Proven);
			}
		}
		catch (const FError& Error)
		{
			// The base ran: what the CPU or the build lacks is the number of lanes, which is not the config's fault.
			const bool bLanes =
				std::ranges::all_of(Error.GetDiagnostics(), [](const FDiagnostic& Each) { return Each.Code == 6003; });
			(bLanes ? Proven.NotRun : Proven.Error) =
				bLanes ? "this CPU or this build has no code for it" : JoinMessages(Error);
		}
		return Proven;
	}

private:
	FPicture RunFinal(const FEquivalenceRun& Run) const { return RunEquivalent(Options, Run, View).Final; }

	FPicture Crop(const FPicture& Final, const FEquivalenceRun& Run) const
	{
		const FViewRect Rect = FindSharedView(Run, View);
		FIntRect Part(Rect[0], Rect[1], Rect[2], Rect[3]);
		Part.Clip(FIntRect(0, 0, Final.Width, Final.Height));
		return Run.Layout == EViewLayout::AsConfigured ? Final : Final.Crop(Part);
	}

	/** Each base runs once. */
	FPicture GetBase(const FEquivalenceRun& Run)
	{
		const auto Known = std::ranges::find_if(Bases, [&Run](const auto& Base) { return Base.first == Run; });
		if (Known != Bases.end())
		{
			return Known->second;
		}
		Bases.push_back({Run, Crop(RunFinal(Run), Run)});
		return Bases.back().second;
	}

	static void Compare(const FPicture& Base, const FPicture& Other, FProven& Proven)
	{
		if (Base.Width != Other.Width || Base.Height != Other.Height || Base.NumChannels != Other.NumChannels)
		{
			Proven.OtherSize = FormatSize(Base) + ", and " + FormatSize(Other);
			return;
		}
		Proven.Final = ComparePixels(Base, Other, Proven.Equivalence->Alike);
		Proven.NumRounded = Proven.Final ? 0 : CountRounded(Base, Other);
	}

	/** Both frames once more, each pass beside its like. */
	void FindFirstPass(FProven& Proven) const
	{
		const FEquivalence& Equivalence = *Proven.Equivalence;
		FPassRecord Record(Equivalence.Alike, Clobbers(Equivalence.Other), Equivalence.Scale);
		FRunOptions Base = Options;
		Base.OnPassExecuted = [&Record](const FPassWrites& Writes)
		{
			Record.Keep(Writes);
		};
		RunEquivalent(Base, Equivalence.Base, View);
		FRunOptions Other = Options;
		Other.OnPassExecuted = [&Record](const FPassWrites& Writes)
		{
			Record.Compare(Writes);
		};
		RunEquivalent(Other, Equivalence.Other, View);
		Proven.FirstPass = Record.GetDifference();
	}

	const FRunOptions Options;
	const FRunResult Plain;
	const FViewRect View;
	std::vector<std::pair<FEquivalenceRun, FPicture>> Bases;
};

} // namespace

FViewRect FindPictureView(const FRunResult& Result)
{
	const FIntRect& Rect = Result.ViewRect;
	const FConfigPadding& Padding = Result.Config.Scene.Padding;
	return {Rect.Min.X - Padding.Left, Rect.Min.Y - Padding.Top, Rect.Max.X - Padding.Left, Rect.Max.Y - Padding.Top};
}

FRunResult RunEquivalent(const FRunOptions& Options, const FEquivalenceRun& Run, const FViewRect& View)
{
	FRunOptions Made = MakeEquivalentRun(Options, Run, View);
	if (Run.bReuse)
	{
		Made.ReuseCache = std::make_shared<FReuseCache>();
		FRunOptions Before = Made;
		Before.OnPassExecuted = nullptr;
		Before.Variables.push_back("r.EyeAdaptation.PreExposureOverride=4");
		RunConfig(Before);
		Before.Variables.pop_back();
		RunConfig(Before);
	}
	return RunConfig(Made);
}

std::vector<FProven> ProveConfig(const FProveOptions& Options)
{
	std::vector<const FEquivalence*> Asked;
	std::vector<std::string> Names;
	for (const FEquivalence& Equivalence : GetEquivalences())
	{
		Names.push_back(Equivalence.Name);
		if (MatchesPattern(Options.Only, Equivalence.Name))
		{
			Asked.push_back(&Equivalence);
		}
	}
	if (Asked.empty())
	{
		throw BadArgument(
			"there is no equivalence '" + Options.Only + "'" + SuggestName(Options.Only, Names), "--only");
	}
	FProver Prover(Options.Run);
	std::vector<FProven> Proven;
	for (const FEquivalence* const Equivalence : Asked)
	{
		if (Options.Progress)
		{
			Options.Progress(static_cast<int>(Proven.size()), static_cast<int>(Asked.size()), Equivalence->Name);
		}
		FProven Unjudged;
		Unjudged.Equivalence = Equivalence;
		Unjudged.NotRun = "the frame is not repeatable";
		const bool bRepeatable = Proven.empty() || Proven[0].Holds() || Proven[0].Equivalence->Name != RepeatName;
		Proven.push_back(bRepeatable ? Prover.Prove(*Equivalence) : Unjudged);
	}
	return Proven;
}

} // namespace Drydock
