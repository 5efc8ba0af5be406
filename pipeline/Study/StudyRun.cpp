// Source: drydock.
#include "Study/StudyRun.h"

#include "ConfigErrors.h"
#include "ContentHash.h"
#include "HAL/IConsoleManager.h"
#include "PostProcessSettingsReflection.h"
#include "Run.h"
#include "RunDump.h"
#include "RunSetup.h"
#include "Study/BlurAlgorithms.h"
#include "Study/BlurNative.h"
#include "Study/StudyRank.h"
#include "Study/StudySubject.h"
#include "TileExecutor.h"
#include "ToonShadowBlur.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

namespace Drydock
{

namespace
{

/** The reference takes longer than what it is compared with, and its time is but a yardstick. */
constexpr int MostReferenceRuns = 3;

using FSet = FStudySet;

/** Stretched over another size, as a bilinear sampler with clamped edges reads it. */
FImage Stretch(const FImage& Image, int Width, int Height)
{
	if (Image.Width == Width && Image.Height == Height)
	{
		return Image;
	}
	FImage Result{Width, Height, Image.NumChannels, {}};
	for (int Y = 0; Y < Height; ++Y)
	{
		const double V = (Y + 0.5) * Image.Height / Height - 0.5;
		const int Y0 = static_cast<int>(std::floor(V));
		for (int X = 0; X < Width; ++X)
		{
			const double U = (X + 0.5) * Image.Width / Width - 0.5;
			const int X0 = static_cast<int>(std::floor(U));
			for (int Channel = 0; Channel < Image.NumChannels; ++Channel)
			{
				const auto Get = [&](int DX, int DY)
				{
					return Image.Get(
						std::clamp(X0 + DX, 0, Image.Width - 1), std::clamp(Y0 + DY, 0, Image.Height - 1), Channel);
				};
				const double Upper = Get(0, 0) + (Get(1, 0) - Get(0, 0)) * (U - X0);
				const double Lower = Get(0, 1) + (Get(1, 1) - Get(0, 1)) * (U - X0);
				Result.Values.push_back(Upper + (Lower - Upper) * (V - Y0));
			}
		}
	}
	return Result;
}

/** Values that the config itself gives to what the axes vary. */
std::map<std::string, std::string> GetCurrentValues(const FRunOptions& Options, const FStudy& Study)
{
	FRunOptions CheckOptions = Options;
	CheckOptions.bUseBudget = false;
	const FRunSetup Setup(CheckOptions);
	std::map<std::string, std::string> Values = {
		{"precision", Options.bDouble ? "double" : "float"}, {"storage", Options.bDouble ? "float64" : "native"}};
	for (const FStudyAxis& Axis : Study.Axes)
	{
		for (const FStudyValue& Value : Axis.Values)
		{
			for (const FStudyAssignment& Assignment : Value.Set)
			{
				const IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(Assignment.Name.c_str());
				const FSettingField* Field = FindSettingField(Assignment.Name);
				FSettingValue Wanted;
				std::string Expected;
				if (Variable != nullptr)
				{
					// In the variable's own words: 1 and true are the same to a bool.
					Values[Assignment.Name] = *Variable->GetString();
				}
				else if (Field != nullptr && SettingFromText(*Field, Assignment.Value, Wanted, Expected) &&
						 SettingToJson(*Field, Wanted) == SettingToJson(*Field, Field->Get(Setup.Chain.Settings)))
				{
					Values[Assignment.Name] = Assignment.Value;
				}
			}
		}
	}
	return Values;
}

bool IsCurrent(const FSet& Set, const std::map<std::string, std::string>& Values)
{
	return std::all_of(Set.begin(), Set.end(),
		[&](const FStudyAssignment& Assignment)
		{
			const auto Found = Values.find(Assignment.Name);
			if (Found == Values.end())
			{
				return false;
			}
			char* End = nullptr;
			const double A = std::strtod(Found->second.c_str(), &End);
			const bool bNumber = !Found->second.empty() && *End == '\0';
			return Found->second == Assignment.Value ||
				   (bNumber && A == std::strtod(Assignment.Value.c_str(), nullptr));
		});
}

std::map<std::string, std::string> GetCurrentOf(const FRunOptions& Options, const FStudy& Study)
{
	if (!Study.bBlur)
	{
		return GetCurrentValues(Options, Study);
	}
	std::map<std::string, std::string> Values;
	for (const FStudyAssignment& Assignment : Study.Current)
	{
		Values[Assignment.Name] = Assignment.Value;
	}
	return Values;
}

// The whole ---------------------------------------------------------------------------------------------------------

struct FPreparedStudy
{
	FCheckResult Check;
	FStudy Study;
	std::unique_ptr<IStudySubject> Subject;
};

/** The study stays where it is: the subject refers to it. */
void PrepareStudy(const FRunOptions& Options, FPreparedStudy& Prepared)
{
	FRunOptions CheckOptions = Options;
	CheckOptions.bUseBudget = false;
	Prepared.Check = CheckConfig(CheckOptions);
	const FConfig& Config = Prepared.Check.Config;
	std::vector<FDiagnostic> Found;
	std::optional<FStudy> Study = ReadStudy(Config, Found);
	if (HasErrors(Found))
	{
		throw FError(Found, ExitUsage);
	}
	if (!Study)
	{
		throw MakeStudyError(ErrorMissingKey, Config, {}, "the config has no \"study\"");
	}
	Prepared.Study = std::move(*Study);
	if (Prepared.Study.bBlur)
	{
		Prepared.Subject = MakeBlurSubject(Config, Prepared.Study);
	}
	else
	{
		Prepared.Subject = MakeFrameSubject(Options, Prepared.Study);
	}
}

class FStudyRunner
{
public:
	explicit FStudyRunner(const FRunOptions& InOptions)
		: Options(InOptions)
	{
		PrepareStudy(Options, Prepared);
	}

	FStudyResult Run()
	{
		const auto Begin = std::chrono::steady_clock::now();
		const FConfig& Config = Prepared.Check.Config;
		Result.Study = Prepared.Study;
		Result.Name = std::filesystem::path(Config.File).stem().string();
		Result.ConfigFile = Config.File;
		Result.Fingerprint = GetStudyFingerprint(GetConfigText(Options));
		Result.Scene = Config.Scene.File.Value;
		Result.Threads = GetNumThreads();
		Result.Diagnostics = Prepared.Check.Diagnostics;
		MakeVariants();
		MeasureErrors();
		MeasureTimes();
		RankStudy(Result);
		Result.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
		return std::move(Result);
	}

private:
	FSet GetSet(const FStudyVariant& Variant) const
	{
		return Join(Result.Jobs[Variant.Case].Case.Set, Choices[Variant.Choice].Set);
	}

	void Show(const std::string& What) const
	{
		if (Options.Progress)
		{
			Options.Progress(NumDone, NumToDo, What);
		}
	}

	void MakeVariants()
	{
		Choices = Prepared.Study.GetChoices();
		const std::map<std::string, std::string> Current = GetCurrentOf(Options, Prepared.Study);
		for (const FStudyCase& Case : Prepared.Study.GetCases())
		{
			FStudyJob Job;
			Job.Case = Case;
			Job.Reference = Prepared.Subject->DescribeReference(Case.Set);
			Result.Jobs.push_back(Job);
			for (size_t Choice = 0; Choice < Choices.size(); ++Choice)
			{
				FStudyVariant Variant;
				Variant.Case = Result.Jobs.size() - 1;
				Variant.Choice = Choice;
				Variant.Label = Choices[Choice].Label;
				Variant.bCurrent = !Current.empty() && IsCurrent(Choices[Choice].Set, Current);
				Result.Jobs.back().Variants.push_back(Result.Variants.size());
				Result.Variants.push_back(std::move(Variant));
			}
		}
		NumToDo = static_cast<int>(Result.Variants.size() * static_cast<size_t>(Prepared.Study.Repetitions + 1));
	}

	/** This is the warm-up too: shaders are compiled and the scene is in memory afterwards. */
	void MeasureErrors()
	{
		for (FStudyJob& Job : Result.Jobs)
		{
			Show(Job.Case.Label + " reference");
			const FMeasured Reference = Prepared.Subject->RunReference(Job.Case.Set);
			Job.ReferenceTaps = Reference.Taps;
			Result.Width = Reference.Image.Width;
			Result.Height = Reference.Image.Height;
			for (const size_t Index : Job.Variants)
			{
				FStudyVariant& Variant = Result.Variants[Index];
				Show(Job.Case.Label + " " + Variant.Label);
				++NumDone;
				Prepared.Subject->Prepare(GetSet(Variant), Variant);
				if (Variant.Excluded.rfind("not run", 0) == 0)
				{
					continue;
				}
				const FMeasured Measured = Prepared.Subject->Run(GetSet(Variant));
				const FImage& Image = Measured.Image;
				FImageErrorOptions ErrorOptions{Measured.Encoding, std::min(3, Reference.Image.NumChannels)};
				Variant.Error = CompareImages(
					Stretch(Image, Reference.Image.Width, Reference.Image.Height), Reference.Image, ErrorOptions);
				Variant.Taps = Measured.Taps;
				Variant.Bytes = Measured.Bytes;
				Variant.bRan = true;
			}
		}
	}

	void MeasureTimes()
	{
		std::vector<std::vector<double>> Runs(Result.Variants.size());
		std::vector<std::vector<double>> ReferenceRuns(Result.Jobs.size());
		std::map<std::string, size_t> Timed; // by key: the variant whose time it is
		for (int Repetition = 0; Repetition < Prepared.Study.Repetitions; ++Repetition)
		{
			for (size_t JobIndex = 0; JobIndex < Result.Jobs.size(); ++JobIndex)
			{
				FStudyJob& Job = Result.Jobs[JobIndex];
				if (Repetition < MostReferenceRuns)
				{
					ReferenceRuns[JobIndex].push_back(Prepared.Subject->RunReference(Job.Case.Set).Milliseconds);
				}
				for (const size_t Index : Job.Variants)
				{
					const FStudyVariant& Variant = Result.Variants[Index];
					const std::string Key = Prepared.Subject->GetTimeKey(GetSet(Variant));
					const bool bFirst = Key.empty() || Timed.emplace(Key, Index).first->second == Index;
					Show(Job.Case.Label + " " + Variant.Label);
					++NumDone;
					if (Variant.bRan && bFirst)
					{
						Runs[Index].push_back(Prepared.Subject->Run(GetSet(Variant)).Milliseconds);
					}
				}
			}
		}
		for (size_t Index = 0; Index < Result.Variants.size(); ++Index)
		{
			FStudyVariant& Variant = Result.Variants[Index];
			const std::string Key = Prepared.Subject->GetTimeKey(GetSet(Variant));
			Variant.Time = SummarizeRuns(Runs[Key.empty() ? Index : Timed.at(Key)]);
		}
		for (size_t JobIndex = 0; JobIndex < Result.Jobs.size(); ++JobIndex)
		{
			Result.Jobs[JobIndex].ReferenceTime = SummarizeRuns(ReferenceRuns[JobIndex]);
		}
	}

	FRunOptions Options;
	FPreparedStudy Prepared;
	std::vector<FStudyChoice> Choices;
	FStudyResult Result;
	int NumDone = 0;
	int NumToDo = 0;
};

/** Keys and values without blanks and comments. */
void AddToHash(const FJsonValue& Value, FContentHash& Hash)
{
	Hash.Add(Value.Describe());
	Hash.Add(Value.String);
	Hash.Add(Value.Bool ? "1" : "0");
	Hash.AddBytes(&Value.Number, sizeof(Value.Number));
	Hash.Add(std::to_string(Value.Elements.size()));
	for (const FJsonValue& Element : Value.Elements)
	{
		AddToHash(Element, Hash);
	}
	for (const FJsonMember& Member : Value.Members)
	{
		Hash.Add(Member.Key);
		AddToHash(Member.Value, Hash);
	}
}

} // namespace

FImage MakeBlurInput(const std::string& Input, const FImage& Scene, double Sigma)
{
	if (Input == "scene")
	{
		return Scene;
	}
	FImage Image{Scene.Width, Scene.Height, 4, {}};
	Image.Values.reserve(Scene.Values.size());
	const int PointX = Scene.Width * 2 / 5;
	const int PointY = Scene.Height * 3 / 5;
	const double Brightness = 2.0 * std::numbers::pi * Sigma * Sigma;
	for (int Y = 0; Y < Scene.Height; ++Y)
	{
		for (int X = 0; X < Scene.Width; ++X)
		{
			const bool bLit =
				Input == "point" ? X == PointX && Y == PointY : 3 * (X - Scene.Width / 2) > Y - Scene.Height / 2;
			const double Value = !bLit ? 0.0 : Input == "point" ? Brightness : 1.0;
			Image.Values.insert(Image.Values.end(), {Value, Value, Value, 1.0});
		}
	}
	return Image;
}

void ApplyToRun(const std::vector<FStudyAssignment>& Set, FRunOptions& Options)
{
	for (const FStudyAssignment& Assignment : Set)
	{
		if (Assignment.Name == "precision")
		{
			Options.bDouble = Assignment.Value == "double";
		}
		else if (Assignment.Name == "storage")
		{
			Options.Storage = Assignment.Value == "float64"   ? ERunStorage::Float64
							  : Assignment.Value == "float32" ? ERunStorage::Float32
															  : ERunStorage::Native;
		}
		else
		{
			const bool bSetting = FindSettingField(Assignment.Name) != nullptr;
			(bSetting ? Options.Settings : Options.Variables).push_back(Assignment.Name + "=" + Assignment.Value);
		}
	}
}

std::string GetConfigText(const FRunOptions& Options)
{
	if (Options.ConfigText)
	{
		return *Options.ConfigText;
	}
	std::ifstream Stream(Options.ConfigFile, std::ios::binary);
	std::stringstream Text;
	Text << Stream.rdbuf();
	return Text.str();
}

std::string GetStudyFingerprint(const std::string& ConfigText)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(ConfigText, "", Ignored, bSyntaxError);
	FContentHash Hash;
	for (const FJsonMember& Member : Root.Members)
	{
		if (Member.Key != "budget" && Member.Key != "outputs" && Member.Key != "$schema")
		{
			Hash.Add(Member.Key);
			AddToHash(Member.Value, Hash);
		}
	}
	return Hash.Finish();
}

FStudyResult RunStudy(const FRunOptions& Options)
{
	return FStudyRunner(Options).Run();
}

FStudyPicture RunStudyPicture(const FRunOptions& Options, const FStudyResult& Result, size_t Job, int Variant)
{
	FPreparedStudy Prepared;
	PrepareStudy(Options, Prepared);
	const FSet& Case = Result.Jobs[Job].Case.Set;
	const FMeasured Reference = Prepared.Subject->RunReference(Case);
	if (Variant < 0)
	{
		return {Reference.Image, Reference.Encoding};
	}
	const size_t Choice = Result.Variants[static_cast<size_t>(Variant)].Choice;
	const FMeasured Measured = Prepared.Subject->Run(Join(Case, Prepared.Study.GetChoices()[Choice].Set));
	return {Stretch(Measured.Image, Reference.Image.Width, Reference.Image.Height), Measured.Encoding};
}

} // namespace Drydock
