// Reads a pipeline, which is YAML: buffers with their values, descriptor sets, what is dispatched and what is expected.
#include "ConformanceTest.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <regex>
#include <sstream>

namespace Drydock::Conformance
{

namespace
{

std::string GetText(const YAML::Node& Map, const char* Key, const std::string& Default = {})
{
	const YAML::Node Value = Map[Key];
	return Value && Value.IsScalar() ? Value.Scalar() : Default;
}

int32_t GetNumber(const YAML::Node& Map, const char* Key, int32_t Default)
{
	const std::string Text = GetText(Map, Key);
	return Text.empty() ? Default : int32_t(std::strtoll(Text.c_str(), nullptr, 0));
}

EFormat ReadFormat(const std::string& Name)
{
	static const std::map<std::string, EFormat> Formats = {{"Hex8", EFormat::Hex8}, {"Hex16", EFormat::Hex16},
		{"Hex32", EFormat::Hex32}, {"Hex64", EFormat::Hex64}, {"UInt16", EFormat::UInt16}, {"UInt32", EFormat::UInt32},
		{"UInt64", EFormat::UInt64}, {"Int16", EFormat::Int16}, {"Int32", EFormat::Int32}, {"Int64", EFormat::Int64},
		{"Float16", EFormat::Float16}, {"Float32", EFormat::Float32}, {"Float64", EFormat::Float64},
		{"Bool", EFormat::Bool}};
	const auto Found = Formats.find(Name);
	if (Found == Formats.end())
	{
		throw FNotRead("a buffer of the format '" + Name + "'");
	}
	return Found->second;
}

template<typename T>
void Append(std::vector<uint8_t>& Bytes, T Value)
{
	const size_t At = Bytes.size();
	Bytes.resize(At + sizeof(T));
	std::memcpy(Bytes.data() + At, &Value, sizeof(T));
}

/** One value of YAML as its bytes. */
void AppendValue(std::vector<uint8_t>& Bytes, EFormat Format, const std::string& Text)
{
	char* End = nullptr;
	if (Format == EFormat::Float32)
	{
		Append(Bytes, std::strtof(Text.c_str(), &End));
	}
	else if (Format == EFormat::Float64)
	{
		Append(Bytes, std::strtod(Text.c_str(), &End));
	}
	else
	{
		const uint64_t Value = std::strtoull(Text.c_str(), &End, 0);
		const uint8_t* const Data = reinterpret_cast<const uint8_t*>(&Value);
		Bytes.insert(Bytes.end(), Data, Data + GetSize(Format));
	}
	if (End == Text.c_str() || *End != '\0')
	{
		throw FNotRead("a value '" + Text + "'");
	}
}

std::vector<uint8_t> ReadValues(const YAML::Node& Values, EFormat Format)
{
	std::vector<uint8_t> Bytes;
	for (const YAML::Node& Value : Values)
	{
		if (!Value.IsNull()) // behind the last comma
		{
			AppendValue(Bytes, Format, Value.Scalar());
		}
	}
	return Bytes;
}

FBuffer ReadBuffer(const YAML::Node& Node)
{
	FBuffer Buffer;
	Buffer.Name = GetText(Node, "Name");
	Buffer.Format = ReadFormat(GetText(Node, "Format"));
	Buffer.Channels = uint32_t(GetNumber(Node, "Channels", 1));
	Buffer.Stride = uint32_t(GetNumber(Node, "Stride", 0));
	const size_t Count = size_t(GetNumber(Node, "ArraySize", 1));
	const size_t Fill = size_t(GetNumber(Node, "FillSize", 0));
	const YAML::Node Data = Node["Data"];
	for (size_t i = 0; i < Count; ++i)
	{
		std::vector<uint8_t> Bytes;
		std::vector<uint8_t> Value;
		AppendValue(Value, Buffer.Format, GetText(Node, "FillValue", "0"));
		while (Bytes.size() < Fill)
		{
			Bytes.insert(Bytes.end(), Value.begin(), Value.end());
		}
		if (Fill == 0 && Data)
		{
			Bytes = ReadValues(Count > 1 ? Data[i] : Data, Buffer.Format);
		}
		Buffer.Members.push_back(std::move(Bytes));
	}
	if (const YAML::Node Props = Node["OutputProps"])
	{
		Buffer.Size = {GetNumber(Props, "Width", 0), GetNumber(Props, "Height", 0), GetNumber(Props, "Depth", 0)};
		Buffer.MipLevels = GetNumber(Props, "MipLevels", 1);
	}
	return Buffer;
}

FResource ReadResource(const YAML::Node& Node, int32_t Set)
{
	for (const char* const Key : {"TilesMapped", "IsReserved", "HeapIndex"})
	{
		if (Node[Key])
		{
			throw FNotRead(std::string("a resource with ") + Key);
		}
	}
	FResource Resource;
	Resource.Name = GetText(Node, "Name");
	Resource.Kind = GetText(Node, "Kind");
	Resource.Set = Set;
	if (const YAML::Node DirectX = Node["DirectXBinding"])
	{
		Resource.Register = GetNumber(DirectX, "Register", -1);
		Resource.Space = GetNumber(DirectX, "Space", 0);
	}
	if (const YAML::Node Vulkan = Node["VulkanBinding"])
	{
		Resource.Binding = GetNumber(Vulkan, "Binding", -1);
	}
	return Resource;
}

FResult ReadResult(const YAML::Node& Node)
{
	FResult Result;
	Result.Name = GetText(Node, "Result");
	Result.Actual = GetText(Node, "Actual");
	Result.Expected = GetText(Node, "Expected");
	Result.bDenormalMayBeZero = GetText(Node, "DenormMode", "Any") == "Any";
	Result.Ulps = uint32_t(GetNumber(Node, "ULPT", 0));
	Result.Epsilon = std::strtod(GetText(Node, "Epsilon", "0").c_str(), nullptr);
	Result.ZeroTolerance = std::strtod(GetText(Node, "ZeroTolerance", "0").c_str(), nullptr);
	const std::string Rule = GetText(Node, "Rule");
	if (Rule != "BufferExact" && Rule != "BufferFloatULP" && Rule != "BufferFloatEpsilon")
	{
		throw FNotRead("the rule '" + Rule + "'");
	}
	Result.Rule = Rule == "BufferExact"      ? ERule::BufferExact
				  : Rule == "BufferFloatULP" ? ERule::BufferFloatULP
											 : ERule::BufferFloatEpsilon;
	return Result;
}

void ReadPushConstants(const YAML::Node& Blocks, std::vector<uint8_t>& Bytes)
{
	for (const YAML::Node& Block : Blocks)
	{
		for (const YAML::Node& Value : Block["Values"])
		{
			const std::vector<uint8_t> Part = ReadValues(Value["Data"], ReadFormat(GetText(Value, "Format")));
			const size_t Offset = size_t(GetNumber(Value, "Offset", 0));
			Bytes.resize(std::max(Bytes.size(), Offset + Part.size()));
			std::memcpy(Bytes.data() + Offset, Part.data(), Part.size());
		}
	}
}

/** All 0. */
void AddCounters(FPipeline& Pipeline, const std::string& Name)
{
	const FBuffer* const Counted = Pipeline.FindBuffer(Name);
	FBuffer Counters;
	Counters.Name = Name + CounterSuffix;
	Counters.Format = EFormat::UInt32;
	Counters.Members.resize(Counted ? Counted->Members.size() : 0, std::vector<uint8_t>(4, 0));
	Pipeline.Buffers.push_back(std::move(Counters));
}

FPipeline ReadPipelineNode(const YAML::Node& Root)
{
	FPipeline Pipeline;
	if (Root["Shaders"].size() != 1 || GetText(Root["Shaders"][0], "Stage") != "Compute")
	{
		throw FNotRead("a pipeline that is not one compute shader");
	}
	for (const YAML::Node& Node : Root["Shaders"][0]["SpecializationConstants"])
	{
		Pipeline.Specialized[GetText(Node, "ConstantID")] = GetText(Node, "Value");
	}
	Pipeline.Entry = GetText(Root["Shaders"][0], "Entry");
	for (const YAML::Node& Node : Root["Buffers"])
	{
		Pipeline.Buffers.push_back(ReadBuffer(Node));
	}
	for (const YAML::Node& Node : Root["Samplers"])
	{
		if (GetText(Node, "MinFilter", "Linear") != GetText(Node, "MagFilter", "Linear"))
		{
			throw FNotRead("a sampler whose two filters differ, which the engine's do not");
		}
		Pipeline.Samplers.push_back({GetText(Node, "Name"), GetText(Node, "MinFilter", "Linear") == "Linear",
			GetText(Node, "Address", "Clamp")});
	}
	for (size_t Set = 0; Set < Root["DescriptorSets"].size(); ++Set)
	{
		for (const YAML::Node& Node : Root["DescriptorSets"][Set]["Resources"])
		{
			Pipeline.Resources.push_back(ReadResource(Node, int32_t(Set)));
			if (GetText(Node, "HasCounter", "false") == "true")
			{
				AddCounters(Pipeline, Pipeline.Resources.back().Name);
			}
		}
	}
	for (const YAML::Node& Node : Root["Results"])
	{
		Pipeline.Results.push_back(ReadResult(Node));
	}
	ReadPushConstants(Root["PushConstants"], Pipeline.PushConstants);
	if (const YAML::Node Counts = Root["DispatchParameters"] ? Root["DispatchParameters"]["DispatchGroupCount"]
															 : YAML::Node(YAML::NodeType::Undefined))
	{
		for (size_t i = 0; i < Counts.size() && i < 3; ++i)
		{
			Pipeline.GroupCount[i] = Counts[i].as<int32_t>();
		}
	}
	return Pipeline;
}

} // namespace

uint32_t GetSize(EFormat Format)
{
	switch (Format)
	{
	case EFormat::Hex8:
		return 1;
	case EFormat::Hex16:
	case EFormat::UInt16:
	case EFormat::Int16:
	case EFormat::Float16:
		return 2;
	case EFormat::Hex64:
	case EFormat::UInt64:
	case EFormat::Int64:
	case EFormat::Float64:
		return 8;
	default:
		return 4;
	}
}

char FResource::GetRegisterClass() const
{
	return Kind.starts_with("RW") ? 'u' : Kind == "ConstantBuffer" ? 'b' : Kind.starts_with("Sampler") ? 's' : 't';
}

FBuffer* FPipeline::FindBuffer(const std::string& Name)
{
	for (FBuffer& Buffer : Buffers)
	{
		if (Buffer.Name == Name)
		{
			return &Buffer;
		}
	}
	return nullptr;
}

const FBuffer* FPipeline::FindBuffer(const std::string& Name) const
{
	return const_cast<FPipeline*>(this)->FindBuffer(Name);
}

bool FPipeline::HasCounters() const
{
	return std::any_of(
		Buffers.begin(), Buffers.end(), [](const FBuffer& Buffer) { return Buffer.Name.ends_with(CounterSuffix); });
}

const FSampler* FPipeline::FindSampler(const std::string& Name) const
{
	for (const FSampler& Sampler : Samplers)
	{
		if (Sampler.Name == Name)
		{
			return &Sampler;
		}
	}
	return nullptr;
}

namespace
{

/** The words of the lines: brackets are words of their own, commas are none, and of a pattern its letters are left. */
std::istringstream MakeCheckWords(const std::vector<std::string>& Lines)
{
	std::string Text;
	for (const std::string& Line : Lines)
	{
		for (const char c : std::regex_replace(Line, std::regex(R"(\{\{|\}\}|\.\*)"), "") + " ")
		{
			Text += c == '[' || c == ']' ? std::string(" ") + c + " " : std::string(1, c == ',' ? ' ' : c);
		}
	}
	return std::istringstream(Text);
}

/** Adds a result whose expected values follow. */
FBuffer& AddChecked(FPipeline& Pipeline, const std::string& Actual)
{
	const FBuffer* const Found = Pipeline.FindBuffer(Actual);
	if (!Found)
	{
		throw FNotRead("a check of '" + Actual + "', which is no buffer");
	}
	FBuffer Empty = *Found;
	Empty.Name = "Checked" + Actual + std::to_string(Pipeline.Buffers.size());
	Empty.Members.clear();
	FResult Result = {Actual, ERule::BufferExact, Actual, Empty.Name};
	if (Empty.Format == EFormat::Float32)
	{
		Result.Rule = ERule::BufferFloatULP;
		Result.Ulps = 42; // the suite's tool prints six digits: half of the last one's unit is 5e-6 of a number
	}
	Result.bFirstOnly = true;
	Pipeline.Results.push_back(Result);
	return Pipeline.Buffers.emplace_back(std::move(Empty));
}

} // namespace

void AddChecks(const std::vector<std::string>& Lines, FPipeline& Pipeline)
{
	std::istringstream Words = MakeCheckWords(Lines);
	std::string Name; // empty: the lists are of the buffers in their order
	std::string Actual;
	FBuffer* Expected = nullptr;
	bool bList = false;
	bool bCounters = false;
	size_t NumLists = 0;
	for (std::string Word; Words >> Word;)
	{
		if (Word == "Name:")
		{
			Words >> Name;
			bList = false;
		}
		else if (Word == "Counter:" || Word == "Counters:" || Word == "Data:")
		{
			bList = true;
			bCounters = Word != "Data:";
			NumLists += bCounters ? 0 : 1;
			Actual = !Name.empty() ? Name + (bCounters ? CounterSuffix : "") : Pipeline.Buffers.at(NumLists - 1).Name;
			Expected = nullptr;
		}
		else if (Word.ends_with(":"))
		{
			Words >> Word; // of the format, the stride ...
			bList = false;
		}
		else if (bList && Word == "]" && Expected)
		{
			Pipeline.Results.back().bFirstOnly = false;
		}
		else if (bList && Word == "[" && Expected && !bCounters)
		{
			Expected->Members.emplace_back();
		}
		else if (bList && Word != "[" && Word != "]" && Word != "-")
		{
			if (!Expected)
			{
				Expected = &AddChecked(Pipeline, Actual);
				Expected->Members.resize(bCounters ? 0 : 1);
			}
			if (bCounters)
			{
				Expected->Members.emplace_back(); // each of a member of its own
			}
			AppendValue(Expected->Members.back(), Expected->Format, Word);
		}
	}
}

FPipeline ReadPipeline(const std::string& Yaml)
{
	try
	{
		return ReadPipelineNode(YAML::Load(Yaml));
	}
	catch (const YAML::Exception& Error)
	{
		throw FNotRead(std::string("the pipeline's YAML: ") + Error.what());
	}
}

} // namespace Drydock::Conformance
