// Draws cost and error of jobs against the number by which they differ.
#include "Study/StudySweep.h"

#include "Study/StudyReport.h"
#include "Study/StudyStyle.h"

#include <algorithm>
#include <cstdlib>

namespace Drydock
{

namespace
{

/** Where a choice's line ends. */
struct FEnd
{
	double X;
	double Y;
	size_t Choice;
	std::string Label;
};

/** Heights for names one below the other, each as near to the wanted one as the others leave room: names that would
 * overlap stand as a block around the mean of what they want. Wanted: ascending. */
std::vector<double> SpreadOut(const std::vector<double>& Wanted, double Step, double Bottom)
{
	struct FBlock
	{
		double Sum; // of what its names want of its first one
		double Count;
		double GetFirst() const { return Sum / Count; }
	};
	std::vector<FBlock> Blocks;
	for (const double Place : Wanted)
	{
		Blocks.push_back({Place, 1.0});
		while (Blocks.size() > 1)
		{
			FBlock& Above = Blocks[Blocks.size() - 2];
			const FBlock& Last = Blocks.back();
			if (Above.GetFirst() + Above.Count * Step <= Last.GetFirst())
			{
				break;
			}
			Above.Sum += Last.Sum - Last.Count * Above.Count * Step;
			Above.Count += Last.Count;
			Blocks.pop_back();
		}
	}
	std::vector<double> Places;
	for (const FBlock& Block : Blocks)
	{
		for (int Index = 0; Index < static_cast<int>(Block.Count); ++Index)
		{
			Places.push_back(Block.GetFirst() + Index * Step);
		}
	}
	for (size_t Index = Places.size(); Index-- > 0;)
	{
		Places[Index] = std::min(Places[Index], Index + 1 == Places.size() ? Bottom : Places[Index + 1] - Step);
	}
	return Places;
}

} // namespace

FStudySweep::FStudySweep(const FStudyView& InView)
	: View(InView)
{
	for (size_t Index = 0; Index < View.Result.Study.Axes.size() && !Axis; ++Index)
	{
		const FStudyAxis& Candidate = View.Result.Study.Axes[Index];
		const bool bNumbers = std::all_of(Candidate.Values.begin(), Candidate.Values.end(),
			[](const FStudyValue& Value)
			{
				char* End = nullptr;
				return std::strtod(Value.Label.c_str(), &End) > 0.0 && *End == '\0';
			});
		if (Candidate.bEach && bNumbers && Candidate.Values.size() >= 3)
		{
			Axis = Index;
		}
	}
	for (const FStudyJob& Job : View.Result.Jobs)
	{
		const std::string Other = GetOther(Job);
		if (std::find(Others.begin(), Others.end(), Other) == Others.end())
		{
			Others.push_back(Other);
		}
	}
}

std::vector<const FStudyJob*> FStudySweep::GetShownJobs() const
{
	std::vector<const FStudyJob*> Jobs;
	for (const FStudyJob& Job : View.Result.Jobs)
	{
		if (!Axis || GetOther(Job) == Others[0])
		{
			Jobs.push_back(&Job);
		}
	}
	return Jobs;
}

std::string FStudySweep::GetOther(const FStudyJob& Job) const
{
	std::string Other;
	for (size_t Index = 0; Index < Job.Case.Values.size(); ++Index)
	{
		if (Axis != Index && !Job.Case.Values[Index].empty())
		{
			Other += (Other.empty() ? "" : ", ") + Job.Case.Values[Index];
		}
	}
	return Other;
}

double FStudySweep::GetNumber(const FStudyJob& Job) const
{
	return std::strtod(Job.Case.Values[*Axis].c_str(), nullptr);
}

std::string FStudySweep::DrawPanel(const FSvgBox& Plot, const std::string& Other, bool bErrors) const
{
	const FStudyResult& Result = View.Result;
	const auto GetValue = [&](const FStudyVariant& Variant)
	{
		return bErrors ? View.GetError(Variant) : View.GetCost(Variant);
	};
	std::vector<double> Numbers;
	std::vector<double> Values;
	for (const FStudyJob& Job : Result.Jobs)
	{
		if (GetOther(Job) != Other)
		{
			continue;
		}
		Numbers.push_back(GetNumber(Job));
		for (const size_t Index : Job.Variants)
		{
			if (Result.Variants[Index].Competes())
			{
				Values.push_back(GetValue(Result.Variants[Index]));
			}
		}
	}
	const FLogAxis X(Numbers, Plot.Left, Plot.Right);
	const FErrorAxis ErrorAxis(bErrors ? Values : std::vector<double>(), {}, Plot);
	const FLogAxis Y = bErrors ? ErrorAxis.GetAxis() : FLogAxis(Values, Plot.Bottom, Plot.Top);
	const FStudyAxis& Swept = Result.Study.Axes[*Axis];
	const std::string AxisName = Swept.Name + (Swept.Name == "sigma" ? ", pixels" : "");
	std::string Svg =
		DrawAxes(Plot, X, Y, Numbers, AxisName, bErrors ? GetErrorTitle(Result.GetMetric()) : View.GetCostName());
	Svg += bErrors ? View.DrawBudget(Plot, Y) : "";
	std::vector<FEnd> Ends;
	std::string Dots;
	for (size_t Choice = 0; Choice < View.GetNumChoices(); ++Choice)
	{
		std::vector<FSvgPoint> Points;
		FEnd End = {0.0, 0.0, Choice, ""};
		for (const FStudyJob& Job : Result.Jobs)
		{
			const FStudyVariant& Variant = Result.Variants[Job.Variants[Choice]];
			const double Value = GetValue(Variant);
			if (GetOther(Job) != Other || !Variant.Competes() || !(Value > 0.0))
			{
				continue;
			}
			End.X = X.Map(GetNumber(Job));
			End.Y = bErrors ? ErrorAxis.Map(Value) : Y.Map(Value);
			End.Label = bErrors ? ErrorAxis.Label(Variant.Label, Value) : Variant.Label;
			Points.emplace_back(End.X, End.Y);
			Dots += DrawStudyMarker(End.X, End.Y, 3.4, Variant.bPlainCode, "dot f" + GetStudyColor(Choice));
		}
		if (!Points.empty())
		{
			Svg += SvgPath(Points, "line s" + GetStudyColor(Choice));
			Ends.push_back(End);
		}
	}
	Svg += Dots;
	const auto DrawName = [&](const FEnd& End, double NameX, double NameY)
	{
		return SvgText(NameX, NameY, "label f" + GetStudyColor(End.Choice), End.Label);
	};
	// A line that ends early has its name there.
	const double LastX = X.Map(*std::max_element(Numbers.begin(), Numbers.end()));
	std::vector<FEnd> AtTheRight;
	for (const FEnd& End : Ends)
	{
		if (End.X < LastX - 1.0)
		{
			Svg += DrawName(End, End.X + 4.0, End.Y + 15.0);
			continue;
		}
		AtTheRight.push_back(End);
	}
	std::stable_sort(AtTheRight.begin(), AtTheRight.end(), [](const FEnd& A, const FEnd& B) { return A.Y < B.Y; });
	std::vector<double> Wanted;
	for (const FEnd& End : AtTheRight)
	{
		Wanted.push_back(End.Y);
	}
	const std::vector<double> Places = SpreadOut(Wanted, 13.5, Plot.Bottom - 2.0);
	for (size_t Index = 0; Index < Places.size(); ++Index)
	{
		const double NameX = Plot.Right + 12.0;
		Svg += SvgLine(AtTheRight[Index].X + 4.0, AtTheRight[Index].Y, NameX - 3.0, Places[Index], "leader");
		Svg += DrawName(AtTheRight[Index], NameX, Places[Index] + 4.0);
	}
	return Svg;
}

std::string FStudySweep::Draw(double& Y) const
{
	if (!Axis)
	{
		return "";
	}
	struct FPanel
	{
		std::string Title;
		std::string Other;
		bool bErrors;
	};
	const std::string Name = View.Result.Study.Axes[*Axis].Name;
	std::vector<FPanel> Panels = {{"What it costs against " + Name, Others[0], false}};
	for (const std::string& Other : Others)
	{
		Panels.push_back({"How far off it is against " + Name + (Other.empty() ? "" : ": " + Other), Other, true});
	}
	constexpr double PanelHeight = 340.0;
	constexpr double NameRoom = 104.0;
	const double PanelWidth = (StudyPageWidth - 2.0 * StudyPageMargin - StudyPanelGap) / 2.0;
	std::string Svg;
	for (size_t Index = 0; Index < Panels.size(); ++Index)
	{
		const double Left = StudyPageMargin + static_cast<double>(Index % 2) * (PanelWidth + StudyPanelGap);
		Svg += SvgText(Left, Y + 18.0, "name", Panels[Index].Title);
		const FSvgBox Plot{
			Left + StudyAxisLeft, Y + StudyPanelTitle, Left + PanelWidth - NameRoom, Y + PanelHeight - StudyAxisBottom};
		Svg += DrawPanel(Plot, Panels[Index].Other, Panels[Index].bErrors);
		Y += Index % 2 == 1 || Index + 1 == Panels.size() ? PanelHeight : 0.0;
	}
	return Svg;
}

} // namespace Drydock
