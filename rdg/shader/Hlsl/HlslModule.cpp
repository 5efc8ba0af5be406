// Puts a module of SPIR-V together out of its sections.
#include "HlslModule.h"

#include <cstring>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

constexpr uint32_t ModuleGenerator = 0; // not registered
constexpr uint32_t ModuleLanguageHlsl = 5;

} // namespace

void AddWords(FWords& To, uint16_t Op, const FWords& Operands)
{
	if (Operands.size() >= UINT16_MAX)
	{
		throw FModuleFault();
	}
	To.push_back(uint32_t(Operands.size() + 1) << 16 | Op);
	To.insert(To.end(), Operands.begin(), Operands.end());
}

void AddString(FWords& To, std::string_view Text)
{
	const size_t First = To.size();
	To.resize(First + Text.size() / sizeof(uint32_t) + 1, 0);
	std::memcpy(To.data() + First, Text.data(), Text.size());
}

uint32_t FModule::Intern(uint16_t Op, const FWords& Operands)
{
	FWords Key = Operands;
	Key.push_back(Op);
	const auto [Found, bNew] = Interned.try_emplace(std::move(Key), Bound);
	if (!bNew)
	{
		return Found->second;
	}
	const uint32_t Id = NewId();
	const bool bConstant = Op >= OpConstantTrue && Op <= OpConstantNull;
	FWords Words = Operands;
	Words.insert(Words.begin() + (bConstant ? 1 : 0), Id);
	AddWords(Globals, Op, Words);
	if (bConstant)
	{
		Constants.insert(Id);
	}
	if (Op == OpConstant && Operands.size() == 2)
	{
		Numbers[Id] = Operands[1];
	}
	return Id;
}

uint32_t FModule::MakeType(uint16_t Op, const FWords& Operands)
{
	const uint32_t Id = NewId();
	FWords Words = Operands;
	Words.insert(Words.begin(), Id);
	AddWords(Globals, Op, Words);
	return Id;
}

bool FModule::FindNumber(uint32_t Id, uint32_t& Value) const
{
	const auto Found = Numbers.find(Id);
	Value = Found == Numbers.end() ? 0 : Found->second;
	return Found != Numbers.end();
}

uint32_t FModule::Global(uint32_t Type, uint32_t Storage, const std::string& VariableName, uint32_t Initializer)
{
	const uint32_t PointerType = Pointer(Storage, Type);
	const uint32_t Id = NewId();
	FWords Words = {PointerType, Id, Storage};
	if (Initializer)
	{
		Words.push_back(Initializer);
	}
	AddWords(Globals, OpVariable, Words);
	Name(Id, VariableName);
	return Id;
}

void FModule::Name(uint32_t Id, std::string_view Text)
{
	FWords Words = {Id};
	AddString(Words, Text.substr(0, 1024));
	AddWords(Names, OpName, Words);
}

void FModule::MemberName(uint32_t Type, uint32_t Member, std::string_view Text)
{
	FWords Words = {Type, Member};
	AddString(Words, Text.substr(0, 1024));
	AddWords(Names, OpMemberName, Words);
}

void FModule::Decorate(uint32_t Id, uint32_t Decoration, const FWords& Operands)
{
	FWords Words = {Id, Decoration};
	Words.insert(Words.end(), Operands.begin(), Operands.end());
	AddWords(Decorations, OpDecorate, Words);
}

void FModule::DecorateMember(uint32_t Type, uint32_t Member, uint32_t Decoration, const FWords& Operands)
{
	FWords Words = {Type, Member, Decoration};
	Words.insert(Words.end(), Operands.begin(), Operands.end());
	AddWords(Decorations, OpMemberDecorate, Words);
}

void FModule::DecorateSemantic(uint32_t Id, std::string_view Semantic)
{
	FWords Words = {Id, DecorationUserSemantic};
	AddString(Words, Semantic.substr(0, 1024));
	AddWords(Decorations, OpDecorateString, Words);
}

void FModule::DecorateCounter(uint32_t Buffer, uint32_t Counter)
{
	AddWords(Decorations, OpDecorateId, {Buffer, DecorationCounterBuffer, Counter});
}

uint32_t FModule::String(const std::string& Text)
{
	const auto [Found, bNew] = StringIds.try_emplace(Text, Bound);
	if (bNew)
	{
		FWords Words = {NewId()};
		AddString(Words, std::string_view(Text).substr(0, 4096));
		AddWords(Strings, OpString, Words);
	}
	return Found->second;
}

void FModule::AddFunction(const FBody& Body)
{
	for (const FWords* Part : {&Body.Head, &Body.Variables, &Body.Prologue, &Body.Code})
	{
		Functions.insert(Functions.end(), Part->begin(), Part->end());
	}
	AddWords(Functions, OpFunctionEnd, {});
}

FWords FModule::Finish(uint32_t Model, uint32_t Entry, std::string_view EntryName, const FWords& Interface,
	const std::vector<FWords>& Modes, bool bWaves)
{
	FWords Result = {Magic, bWaves ? 0x10300u : 0x10000u, ModuleGenerator << 16, Bound, 0};
	for (const uint32_t Number : Capabilities)
	{
		AddWords(Result, OpCapability, {Number});
	}
	for (const std::string& Text : Extensions)
	{
		FWords Words;
		AddString(Words, Text);
		AddWords(Result, OpExtension, Words);
	}
	FWords Import = {Extended};
	AddString(Import, "GLSL.std.450");
	AddWords(Result, OpExtInstImport, Import);
	AddWords(Result, OpMemoryModel, {0, 1}); // Logical, GLSL450
	FWords Point = {Model, Entry};
	AddString(Point, EntryName);
	Point.insert(Point.end(), Interface.begin(), Interface.end());
	AddWords(Result, OpEntryPoint, Point);
	for (const FWords& Mode : Modes)
	{
		FWords Words = {Entry};
		Words.insert(Words.end(), Mode.begin(), Mode.end());
		AddWords(Result, OpExecutionMode, Words);
	}
	Result.insert(Result.end(), Strings.begin(), Strings.end());
	AddWords(Result, OpSource, {ModuleLanguageHlsl, 500});
	for (const FWords* Part : {&Names, &Decorations, &Globals, &Functions})
	{
		Result.insert(Result.end(), Part->begin(), Part->end());
	}
	return Result;
}

} // namespace Drydock::Hlsl
