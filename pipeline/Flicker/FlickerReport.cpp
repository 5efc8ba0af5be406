// Turns figures of flicker into text, JSON, SVG and PNG.
#include "Flicker/FlickerReport.h"

#include "Picture/Chart.h"
#include "Picture/Preview.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextTable.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

/** The row of that name, or null: another variant need not run the same effects. */
const FFlickerRow* FindRow(const FFlickerVariant& Variant, const std::string& Name)
{
	const auto Found = std::ranges::find_if(Variant.Rows, [&](const FFlickerRow& Row) { return Row.Name == Name; });
	return Found == Variant.Rows.end() ? nullptr : &*Found;
}

/** Names of all rows, in the order of the first variant that has them. */
std::vector<std::string> ListRows(const FFlickerResult& Result)
{
	std::vector<std::string> Names;
	for (const FFlickerVariant& Variant : Result.Variants)
	{
		for (const FFlickerRow& Row : Variant.Rows)
		{
			if (std::ranges::find(Names, Row.Name) == Names.end())
			{
				Names.push_back(Row.Name);
			}
		}
	}
	return Names;
}

std::string MakeNotes(const FFlickerResult& Result)
{
	std::string Text =
		Result.Truth.empty()
			? "There is no truth (NAME.truth.####.exr, or --truth): only a steady change of the scene is "
			  "left out of the figures.\n"
			: "The scene's own change is that of " + Result.Truth + " without antialiasing.\n";
	for (const std::string& Name : Result.Unmeasured)
	{
		Text += "not measured: " + Name + ", which the truth does not have in this size\n";
	}
	return Text;
}

} // namespace

std::string MakeFlickerTable(const FFlickerResult& Result, int Width)
{
	FTextTable Table;
	Table.Columns = {{ETextColumn::Name}, {ETextColumn::Text}, {ETextColumn::Number}, {ETextColumn::Number},
		{ETextColumn::Number}, {ETextColumn::Number}, {ETextColumn::Text, 2}, {ETextColumn::Number, 1}};
	Table.Rows.push_back(
		{"light of", "run", "mean jump %", "worst %", "frame", "worst pixel", "at, frame", "error to truth"});
	for (const std::string& Name : ListRows(Result))
	{
		for (const FFlickerVariant& Variant : Result.Variants)
		{
			const FFlickerRow* const Row = FindRow(Variant, Name);
			const FFlickerFrame* const Jump = Row != nullptr ? Row->Figures.FindWorstJump() : nullptr;
			if (Jump == nullptr)
			{
				continue;
			}
			const FFlickerFrame* const Pixel = Row->Figures.FindWorstPixel();
			Table.Rows.push_back({Name, Variant.Name, fmt::format("{:.3f}", Row->Figures.GetMeanJump()),
				fmt::format("{:.3f}", Jump->Jump), std::to_string(Jump->Frame),
				fmt::format("{:.3g}", Pixel->WorstPixel),
				fmt::format("{},{} in {}", Pixel->WorstPlace.X, Pixel->WorstPlace.Y, Pixel->Frame),
				Row->Figures.GetLastError() ? fmt::format("{:.3g}", *Row->Figures.GetLastError()) : "-"});
		}
	}
	return Table.Format(Width) + MakeNotes(Result);
}

std::string MakeFlickerJson(const FFlickerResult& Result)
{
	FJsonWriter Writer('{');
	Writer.Member("frames", Result.Frames);
	Writer.Key("truth");
	Result.Truth.empty() ? Writer.Null() : Writer.Value(Result.Truth);
	Writer.Member("notMeasured", Result.Unmeasured);
	Writer.Array("runs", Result.Variants,
		[&](const FFlickerVariant& Variant)
		{
			Writer.BeginObject();
			Writer.Member("name", Variant.Name);
			Writer.Member("variables", Variant.Variables);
			Writer.Array("light", Variant.Rows,
				[&](const FFlickerRow& Row)
				{
					const FFlickerFrame* const Pixel = Row.Figures.FindWorstPixel();
					const FFlickerFrame* const Jump = Row.Figures.FindWorstJump();
					Writer.BeginObject();
					Writer.Member("of", Row.Name);
					Writer.Member("meanJumpPercent", Row.Figures.GetMeanJump());
					Writer.Member("worstJumpPercent", Jump != nullptr ? Jump->Jump : 0.0);
					Writer.Member("worstPixel", Pixel != nullptr ? Pixel->WorstPixel : 0.0);
					Writer.Array("frames", Row.Figures.Frames,
						[&](const FFlickerFrame& Frame)
						{
							Writer.BeginObject(true);
							Writer.Member("frame", Frame.Frame);
							Writer.Member("mean", Frame.Mean);
							Writer.Member("meanOfTruth", Frame.MeanOfTruth);
							Writer.Member("errorToTruth", Frame.Error);
							Writer.Member("jumpPercent", Frame.Jump);
							Writer.Member("worstPixel", Frame.WorstPixel);
							Writer.Member("at", {Frame.WorstPlace.X, Frame.WorstPlace.Y});
							Writer.EndObject();
						});
					Writer.EndObject();
				});
			Writer.EndObject();
		});
	return Writer.GetText();
}

std::string MakeFlickerChart(const FFlickerResult& Result, const std::string& Title)
{
	FChart Chart;
	Chart.Title = Title;
	Chart.Notes = {"jump of the mean light from frame to frame, percent"};
	Chart.MarkName = "frame";
	std::vector<FChartLegend>& Legend = Chart.Legend.emplace_back();
	for (size_t Variant = 0; Variant < Result.Variants.size(); ++Variant)
	{
		Legend.push_back({Result.Variants[Variant].Name, "c" + std::to_string(Variant % 10), {}});
	}
	const double First = Result.Frames.front();
	const double Last = Result.Frames.back();
	for (const std::string& Name : ListRows(Result))
	{
		FChartPanel Panel;
		Panel.Title = Name;
		Panel.Unit = "%";
		Panel.Height = 92.0;
		Panel.X = MakeLinearAxis("frame", First, Last, 8);
		double Greatest = 0.0;
		for (size_t Variant = 0; Variant < Result.Variants.size(); ++Variant)
		{
			const FFlickerRow* const Row = FindRow(Result.Variants[Variant], Name);
			if (Row == nullptr)
			{
				continue;
			}
			FChartSeries& Series = Panel.Series.emplace_back();
			Series.Name = Result.Variants[Variant].Name;
			Series.Color = "c" + std::to_string(Variant % 10);
			for (const FFlickerFrame& Frame : Row->Figures.Frames)
			{
				Greatest = std::max(Greatest, Frame.Jump);
				Series.Line.emplace_back(Frame.Frame, Frame.Jump);
				Series.Points.push_back({.X = static_cast<double>(Frame.Frame),
					.Y = Frame.Jump,
					.Tip = fmt::format("frame {}: {:.3f} %, {}", Frame.Frame, Frame.Jump, Series.Name)});
			}
		}
		Panel.Y = MakeLinearAxis("", 0.0, Greatest > 0.0 ? 1.1 * Greatest : 1.0, 4);
		Chart.Panels.push_back(std::move(Panel));
	}
	return DrawChart(Chart);
}

std::vector<std::string> WriteFlickerPictures(const FFlickerResult& Result, const std::string& Folder)
{
	std::vector<std::string> Names;
	for (const std::string& Name : ListRows(Result))
	{
		double Greatest = 0.0;
		for (const FFlickerVariant& Variant : Result.Variants)
		{
			const FFlickerRow* const Row = FindRow(Variant, Name);
			for (const double Value : Row != nullptr ? Row->Figures.Where.Values : std::vector<double>())
			{
				Greatest = std::max(Greatest, Value);
			}
		}
		for (size_t Index = 0; Index < Result.Variants.size(); ++Index)
		{
			const FFlickerRow* const Row = FindRow(Result.Variants[Index], Name);
			if (Row == nullptr || Row->Figures.Where.Values.empty())
			{
				continue;
			}
			FImage Where = Row->Figures.Where;
			for (double& Value : Where.Values)
			{
				Value = Greatest > 0.0 ? Value / Greatest : 0.0;
			}
			Names.push_back("where." + Name + (Index > 0 ? "." + std::to_string(Index + 1) : "") + ".png");
			WritePreviewPng((std::filesystem::path(Folder) / Names.back()).string(), Where);
		}
	}
	return Names;
}

} // namespace Drydock
