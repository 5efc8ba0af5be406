// Writes the results of a study as a table, JSON and CSV.
#include "Study/StudyReport.h"

#include "RangeTools.h"
#include "Run/RunJson.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"
#include "Text/TextTable.h"
#include "Text/Version.h"

#include <array>
#include <cmath>

namespace Drydock
{

namespace
{

using FRow = std::vector<std::string>;

/** The columns of MakeStudyTable. The column that matters least for the choice goes first if there is no room. */
std::vector<FTextColumn> GetColumns(const std::string& Metric)
{
	constexpr ETextColumn Number = ETextColumn::Number;
	const auto OfError = [&Metric](const char* Name, int LeaveOut)
	{
		return FTextColumn{Number, Metric == Name ? 0 : LeaveOut};
	};
	return {{ETextColumn::Name}, {Number}, {Number, 4}, {Number, 5}, OfError("max", 6), OfError("rms", 1),
		OfError("relative", 7), OfError("psnr", 8), OfError("ssim", 9), OfError("flip", 10), {Number, 2}, {Number, 3},
		{ETextColumn::Text}};
}

std::string DescribeRank(const FStudyResult& Result, const FStudyVariant& Variant)
{
	std::string Text;
	const bool bExcluded = Variant.Exclusion != EStudyExclusion::None;
	if (bExcluded)
	{
		Text = Variant.Excluded;
	}
	else if (Variant.ByTime.bFront)
	{
		Text = "front";
	}
	else
	{
		const size_t By = static_cast<size_t>(Variant.ByTime.DominatedBy);
		const bool bNoise = Contains(Variant.WithinNoiseOf, By);
		Text = "dominated by " + Result.Variants[By].Label + (bNoise ? " (time within noise)" : "");
	}
	Text += Variant.bPlainCode && !bExcluded ? ", plain code" : "";
	Text += Variant.bRecommended ? ", recommended" : "";
	return Text + (Variant.bCurrent ? ", in use now" : "");
}

FRow MakeRow(const FStudyResult& Result, const FStudyJob& Job, const FStudyVariant& Variant)
{
	if (!Variant.bRan)
	{
		return {Variant.Label, "", "", "", "", "", "", "", "", "",
			Variant.Taps > 0.0 ? fmt::format("{:.0f}", Variant.Taps) : "", "", DescribeRank(Result, Variant)};
	}
	const FImageError& Error = Variant.Error;
	const double Times = Variant.Time.Median > 0.0 ? Job.ReferenceTime.Median / Variant.Time.Median : 0.0;
	return {Variant.Label, fmt::format("{:.2f}", Variant.Time.Median),
		fmt::format("{:.2f}", Variant.Time.High - Variant.Time.Low), fmt::format("{:.3g}", Times),
		fmt::format("{:.3g}", Error.Max), fmt::format("{:.3g}", Error.Rms), fmt::format("{:.3g}", Error.Relative),
		fmt::format("{:.1f}", Error.Psnr), fmt::format("{:.5f}", Error.Ssim), fmt::format("{:.4f}", Error.Flip),
		std::isnan(Variant.Taps) ? "" : fmt::format("{:.1f}", Variant.Taps), fmt::format("{:.0f}", Variant.Bytes),
		DescribeRank(Result, Variant)};
}

/** Names the pairs of variants that are equally fast; only pairs of the front, since a choice is made among these. */
std::string DescribeNoise(const FStudyResult& Result, const FStudyJob& Job, int Width)
{
	constexpr size_t Otherwise = 130;
	const size_t MostCharacters = Width > 0 ? static_cast<size_t>(Width) : Otherwise;
	std::string Text;
	std::string Line = "  within noise of one another: ";
	const size_t Indent = Line.size();
	for (const size_t Index : Job.Variants)
	{
		const FStudyVariant& Variant = Result.Variants[Index];
		for (const size_t Other : Variant.WithinNoiseOf)
		{
			if (Other <= Index || !Variant.ByTime.bFront || !Result.Variants[Other].ByTime.bFront)
			{
				continue;
			}
			const std::string Pair = Variant.Label + " and " + Result.Variants[Other].Label;
			if (Line.size() > Indent && Line.size() + Pair.size() > MostCharacters)
			{
				Text += Line + ";\n";
				Line = std::string(Indent, ' ');
			}
			Line += (Line.size() > Indent ? "; " : "") + Pair;
		}
	}
	return Line.size() == Indent ? "" : Text + Line + "\n";
}

void WriteSet(FJsonWriter& Writer, const std::vector<FStudyAssignment>& Set)
{
	Writer.Object(
		"set", Set, [&](const FStudyAssignment& Assignment) { Writer.Member(Assignment.Name, Assignment.Value); });
}

void WriteDominator(FJsonWriter& Writer, const FStudyResult& Result, const FStudyRank& Rank)
{
	Writer.Members({{"front", Rank.bFront},
		{"dominatedBy",
			Rank.DominatedBy < 0 ? std::string() : Result.Variants[static_cast<size_t>(Rank.DominatedBy)].Label}});
}

void WriteVariant(
	FJsonWriter& Writer, const FStudyResult& Result, const FStudyVariant& Variant, const FStudyChoice& Choice)
{
	Writer.BeginObject(true);
	Writer.Member("label", Variant.Label);
	WriteSet(Writer, Choice.Set);
	Writer.Member("excluded", Variant.Excluded);
	if (Variant.bRan)
	{
		for (const std::string& Metric : GetMetricNames())
		{
			Writer.Member(Metric, GetMetric(Variant.Error, Metric));
		}
		Writer.Member("nonFinite", Variant.Error.NumNonFinite);
		if (Result.Study.Region)
		{
			Writer.Member("relativeWithBorder", Variant.RelativeWithBorder);
		}
	}
	Writer.Members({{"taps", Variant.Taps}, {"bytes", Variant.Bytes}});
	if (Result.Study.bBlur)
	{
		Writer.Members({{"sigma", Variant.MeasuredSigma}, {"plainCode", Variant.bPlainCode}});
	}
	Writer.Member("current", Variant.bCurrent);
	WriteDominator(Writer, Result, Variant.ByTaps);
	Writer.EndObject();
}

void WriteBudget(FJsonWriter& Writer, const FStudyBudget& Budget)
{
	Writer.Key("budget").BeginObject(true);
	Writer.Member("metric", Budget.Metric);
	Writer.MemberIfAny("max", Budget.Max);
	Writer.MemberIfAny("ms", Budget.Ms);
	Writer.Member("default", Budget.bDefault);
	Writer.EndObject();
}

} // namespace

std::string DescribeStudied(const FStudyResult& Result)
{
	std::string Text = fmt::format("{}, {} x {}", Result.Scene, Result.Width, Result.Height);
	if (Result.Study.Region)
	{
		const auto& [MinX, MinY, MaxX, MaxY] = *Result.Study.Region;
		Text += fmt::format(", errors of {} x {} at ({}, {})", MaxX - MinX, MaxY - MinY, MinX, MinY);
	}
	return Text;
}

std::string GetErrorTitle(const std::string& Metric)
{
	return Metric == "rms"        ? "RMS error"
		   : Metric == "max"      ? "largest error"
		   : Metric == "relative" ? "relative error"
		   : Metric == "psnr"     ? "10^(-PSNR/20)"
		   : Metric == "flip"     ? "FLIP"
								  : "1 - SSIM";
}

std::string MakeStudyTable(const FStudyResult& Result, int Width)
{
	std::string Text = fmt::format("{}: {}; {}, {} threads, medians of {} interleaved runs, spread between quartiles\n",
		Result.Name, DescribeStudied(Result), GetCpuName(), Result.Threads, Result.Study.Repetitions);
	for (const FStudyJob& Job : Result.Jobs)
	{
		std::vector<FRow> Rows = {{"variant", "CPU ms", "spread", "x ref", "max", "rms", "relative", "PSNR", "SSIM",
			"FLIP", "taps/px", "bytes/px", "front of " + Result.GetMetric() + " and time"}};
		for (const size_t Index : Job.Variants)
		{
			Rows.push_back(MakeRow(Result, Job, Result.Variants[Index]));
		}
		Text += fmt::format("\n{}reference: {}, {:.1f} ms\n{}{}  recommended  {}\n",
			Job.Case.Label.empty() ? "" : Job.Case.Label + "; ", Job.Reference, Job.ReferenceTime.Median,
			FTextTable{GetColumns(Result.GetMetric()), Rows}.Format(Width, "  "), DescribeNoise(Result, Job, Width),
			Job.Recommendation);
	}
	return Text;
}

std::string MakeStudyJson(const FStudyResult& Result)
{
	const std::vector<FStudyChoice> Choices = Result.Study.GetChoices();
	FJsonWriter Writer('{');
	Writer.Members({{"version", GetVersion()}, {"config", Result.ConfigFile}, {"fingerprint", Result.Fingerprint},
		{"scene", Result.Scene}, {"size", std::array{Result.Width, Result.Height}}});
	Writer.MemberIfAny("region", Result.Study.Region);
	Writer.Members({{"subject", Result.Study.bBlur ? "blurs" : "frames"}, {"reference", Result.Study.ReferenceName},
		{"metric", Result.GetMetric()}});
	WriteBudget(Writer, Result.Study.Budget);
	Writer.Array("axes", Result.Study.Axes,
		[&](const FStudyAxis& Axis)
		{
			Writer.Object({{"name", Axis.Name}, {"each", Axis.bEach},
				{"values", Axis.Values | std::views::transform(&FStudyValue::Label)}});
		});
	Writer.Array("jobs", Result.Jobs,
		[&](const FStudyJob& Job)
		{
			Writer.BeginObject();
			Writer.Member("label", Job.Case.Label);
			WriteSet(Writer, Job.Case.Set);
			Writer.Members({{"reference", Job.Reference}, {"referenceTaps", Job.ReferenceTaps}});
			Writer.Array("variants", Job.Variants,
				[&](const size_t Index)
				{ WriteVariant(Writer, Result, Result.Variants[Index], Choices[Result.Variants[Index].Choice]); });
			Writer.EndObject();
		});
	return Writer.GetText();
}

std::string MakeStudyTimingJson(const FStudyResult& Result)
{
	FJsonWriter Writer('{');
	Writer.Members({{"cpu", GetCpuName()}, {"threads", Result.Threads}, {"repetitions", Result.Study.Repetitions},
		{"seconds", Result.Seconds}});
	Writer.Array("jobs", Result.Jobs,
		[&](const FStudyJob& Job)
		{
			Writer.BeginObject();
			Writer.Members({{"label", Job.Case.Label}, {"referenceMs", Job.ReferenceTime.Median}});
			std::string Recommended;
			for (const size_t Index : Job.Variants)
			{
				Recommended = Result.Variants[Index].bRecommended ? Result.Variants[Index].Label : Recommended;
			}
			Writer.Members({{"recommended", Recommended}, {"recommendation", Job.Recommendation}});
			Writer.Array("variants", Job.Variants,
				[&](const size_t Index)
				{
					const FStudyVariant& Variant = Result.Variants[Index];
					Writer.BeginObject(true);
					Writer.Member("label", Variant.Label);
					if (Variant.bRan)
					{
						Writer.Members({{"medianMs", Variant.Time.Median}, {"lowMs", Variant.Time.Low},
							{"highMs", Variant.Time.High}, {"runsMs", Variant.Time.Runs}});
					}
					WriteDominator(Writer, Result, Variant.ByTime);
					Writer.Member("withinNoiseOf",
						Variant.WithinNoiseOf |
							std::views::transform([&](size_t Other) { return Result.Variants[Other].Label; }));
					Writer.EndObject();
				});
			Writer.EndObject();
		});
	return Writer.GetText();
}

std::string MakeStudyCsv(const FStudyResult& Result, bool bTiming)
{
	const std::vector<FStudyChoice> Choices = Result.Study.GetChoices();
	std::string Text;
	for (const FStudyAxis& Axis : Result.Study.Axes)
	{
		Text += CsvText(Axis.Name) + ",";
	}
	for (const std::string& Metric : GetMetricNames())
	{
		Text += Metric + ",";
	}
	Text += Result.Study.Region ? "relative_with_border," : "";
	Text += bTiming ? "median_ms,low_ms,high_ms,times_reference,front_by_time,recommended\n"
					: "taps_per_pixel,bytes_per_pixel,sigma,front_by_taps,excluded\n";
	for (const FStudyVariant& Variant : Result.Variants)
	{
		const FStudyJob& Job = Result.Jobs[Variant.Case];
		for (size_t Axis = 0; Axis < Result.Study.Axes.size(); ++Axis)
		{
			const bool bEach = Result.Study.Axes[Axis].bEach;
			Text += CsvText(bEach ? Job.Case.Values[Axis] : Choices[Variant.Choice].Values[Axis]) + ",";
		}
		for (const std::string& Metric : GetMetricNames())
		{
			Text += (Variant.bRan ? fmt::format("{:.17g}", GetMetric(Variant.Error, Metric)) : "") + ",";
		}
		if (Result.Study.Region)
		{
			Text += (Variant.bRan ? fmt::format("{:.17g}", Variant.RelativeWithBorder) : "") + ",";
		}
		if (bTiming)
		{
			const FStudyTime& Time = Variant.Time;
			const double Times = Time.Median > 0.0 ? Job.ReferenceTime.Median / Time.Median : 0.0;
			Text += Variant.bRan ? fmt::format("{:.4f},{:.4f},{:.4f},{:.4g},", Time.Median, Time.Low, Time.High, Times)
								 : ",,,,";
			Text += fmt::format("{:d},{:d}\n", Variant.ByTime.bFront, Variant.bRecommended);
			continue;
		}
		Text +=
			fmt::format("{},{:.17g},{},{:d},{}\n", std::isnan(Variant.Taps) ? "" : fmt::format("{:.17g}", Variant.Taps),
				Variant.Bytes, Variant.MeasuredSigma > 0.0 ? fmt::format("{:.17g}", Variant.MeasuredSigma) : "",
				Variant.ByTaps.bFront, CsvText(Variant.Excluded));
	}
	return Text;
}

} // namespace Drydock
