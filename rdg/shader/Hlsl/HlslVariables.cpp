// Variables of the file: parameters of the shader, constants, resources, those of cbuffers, when one is first named.
#include "HlslAnalysisImpl.h"

#include <algorithm>
#include <utility>

namespace Drydock::Hlsl
{

namespace
{

constexpr uint64_t MaxBufferBytes = 65536;

/** Bytes of `c3.y`; nothing where it is not of that form. */
std::optional<uint32_t> ReadPackOffset(std::string_view Text)
{
	const size_t Point = Text.find('.');
	const std::string Register(Text.substr(0, Point));
	if (Register.size() < 2 || Register.size() > 5 || Register[0] != 'c' ||
		Register.find_first_not_of("0123456789", 1) != std::string::npos)
	{
		return std::nullopt;
	}
	const std::string_view Component = Point == std::string_view::npos ? "x" : Text.substr(Point + 1);
	size_t At = std::string_view("xyzw").find(Component);
	At = At == std::string_view::npos ? std::string_view("rgba").find(Component) : At;
	return At == std::string_view::npos || Component.size() != 1
			   ? std::nullopt
			   : std::optional<uint32_t>(uint32_t(std::stoul(Register.substr(1)) * 16 + At * 4));
}

} // namespace

FVariable* FAnalyser::FindGlobal(FSymbol& Symbol)
{
	if (Symbol.Variable)
	{
		return Symbol.Variable;
	}
	if (Symbol.bBusy)
	{
		Error(Symbol.Place, "X3004: the type of '" + std::string(Symbol.Name) + "' depends on itself");
		return nullptr;
	}
	Symbol.bBusy = true;
	FPosition Position;
	Position.Scope = Symbol.Scope;
	Position.Order = Symbol.Order ? Symbol.Order : NumDeclarations;
	Position.bStatic = true;
	const FPositionGuard Guard(*this, Position);
	if (Symbol.Buffer)
	{
		MakeBuffer(*Symbol.Buffer, *Symbol.Scope);
	}
	else
	{
		const std::string Outer = std::exchange(Instance, std::string());
		MakeGlobal(Symbol, *Program->Make<FVariable>());
		Instance = Outer;
	}
	Symbol.bBusy = false;
	return Symbol.Variable;
}

void FAnalyser::MakeGlobal(FSymbol& Symbol, FVariable& Variable)
{
	const FDeclaration& Declaration = *Symbol.Declaration;
	const FExpression* const Value =
		Symbol.Definition && Symbol.Definition->Value ? Symbol.Definition->Value : Declaration.Value;
	Variable.Name = Symbol.Scope->Kind == EScopeKind::File ? std::string(Symbol.Name)
														   : Symbol.Scope->Prefix + std::string(Symbol.Name);
	Variable.Place = Declaration.Place;
	Variable.Modifiers = Declaration.Modifiers | Declaration.Type->Modifiers;
	Variable.ResourceName = Variable.Name;
	Variable.Type = FindDeclaredType(Declaration);
	const bool bStatic = (Variable.Modifiers & ModifierStatic) != 0;
	const bool bObject = HasObject(Variable.Type);
	const bool bConst = (Variable.Modifiers & ModifierConst) != 0 && Value;
	const FMade Made{Symbol.Order, &Variable};
	Symbol.Variable = &Variable;
	if (bObject && !bStatic)
	{
		Variable.Storage = EStorage::Resource;
		Resources.push_back(Made);
		if (CountScalars(Variable.Type) > 0)
		{
			Error(Variable.Place,
				"'" + Variable.Name +
					"' has numbers beside its resources, which a parameter of the shader cannot; declare them apart");
		}
		return;
	}
	if (Variable.Modifiers & ModifierGroupshared)
	{
		Variable.Storage = EStorage::Groupshared;
		Statics.push_back(Made);
		if (Value)
		{
			Error(Value->Place, "'" + Variable.Name +
									"': groupshared variables have no initial values; set it in the shader, and wait "
									"by GroupMemoryBarrierWithGroupSync()");
		}
		if (Options.Stage != EStage::Compute)
		{
			Error(Variable.Place, "'" + Variable.Name + "': only compute shaders have groupshared variables");
		}
	}
	else if (bStatic || bConst || Variable.Type->Kind == EType::Error)
	{
		Variable.Storage = EStorage::Static;
		if (Value)
		{
			Variable.Initializer = Initialise(Variable.Type, *Value);
			Variable.Type = Variable.Type->Kind == EType::Error ? Variable.Type : Variable.Initializer->Type;
			SetConstant(Variable);
		}
		Statics.push_back(Made);
		if (!bStatic && Variable.Type->Kind != EType::Error)
		{
			Warn(Variable.Place,
				"'" + Variable.Name +
					"' is not static: D3D's compilers take it as a parameter of the shader; write static const");
		}
	}
	else
	{
		AddLoose(Variable, Declaration);
		Loose.push_back(Made);
		if (Value)
		{
			Warn(Value->Place, "the initial value of '" + Variable.Name +
								   "' is not used: it is a parameter of the shader; write static");
		}
	}
	if (Variable.Type->IsArray() && Variable.Type->Count == 0)
	{
		Error(Variable.Place, "X3072: '" + Variable.Name + "': the size of an array must be given");
		Variable.Type = Types->Error();
	}
}

void FAnalyser::SetConstant(FVariable& Variable)
{
	const FValue* const Value = Variable.Initializer;
	const bool bPlain = Variable.Modifiers & ModifierConst && Value && Value->Type == Variable.Type &&
						Value->Type->Kind != EType::Error && !HasObject(Value->Type);
	if (bPlain && IsKnown(*Value))
	{
		Variable.Constant = Fold(*Types, *Value);
	}
}

void FAnalyser::AddLoose(FVariable& Variable, const FDeclaration& Declaration)
{
	if (!Global)
	{
		Global = Program->Make<FBuffer>();
		Global->Name = "$Global";
	}
	Variable.Storage = EStorage::Loose;
	Variable.Buffer = Global;
	ReadOffset(Variable, Declaration);
}

void FAnalyser::ReadOffset(FVariable& Variable, const FDeclaration& Declaration)
{
	for (const FAnnotation& Annotation : Declaration.Annotations)
	{
		if (Annotation.Name == "packoffset" && !Annotation.Arguments.empty())
		{
			if (const std::optional<uint32_t> Offset = ReadPackOffset(Annotation.Arguments[0]))
			{
				Offsets[&Variable] = *Offset;
			}
			else
			{
				Error(Annotation.Place, "X3530: '" + std::string(Annotation.Arguments[0]) +
											"' is no place in a buffer; write packoffset(c0.x)");
			}
		}
	}
}

void FAnalyser::MakeBuffer(const FDeclaration& Declaration, FNameScope& Scope)
{
	FBuffer& Buffer = *Program->Make<FBuffer>();
	Buffer.Name = std::string(Declaration.Name.Parts.empty() ? "" : Declaration.Name.Last());
	Buffer.Place = Declaration.Place;
	Buffer.bTBuffer = Declaration.bTBuffer;
	uint32_t Order = Here.Order;
	for (const FDeclaration* Member : Declaration.Members)
	{
		const auto Found =
			Member->Kind == EDeclaration::Variable ? Scope.Symbols.find(Member->Name.Last()) : Scope.Symbols.end();
		if (Found == Scope.Symbols.end() || Found->second.Declaration != Member || Found->second.Variable)
		{
			continue;
		}
		FSymbol& Symbol = Found->second;
		Order = std::min(Order, Symbol.Order);
		FVariable& Variable = *Program->Make<FVariable>();
		Variable.Name = std::string(Symbol.Name);
		Variable.Place = Member->Place;
		Variable.Modifiers = Member->Modifiers | Member->Type->Modifiers;
		Variable.ResourceName = Variable.Name;
		Here.Order = Symbol.Order;
		Variable.Type = FindDeclaredType(*Member);
		if (Variable.Type->IsArray() && Variable.Type->Count == 0)
		{
			Error(Variable.Place, "X3072: '" + Variable.Name + "': the size of an array must be given");
			Variable.Type = Types->Error();
		}
		Symbol.Variable = &Variable;
		if (HasObject(Variable.Type))
		{
			Variable.Storage = EStorage::Resource;
			Resources.push_back({Symbol.Order, &Variable});
			continue;
		}
		ReadOffset(Variable, *Member);
		Variable.Storage = EStorage::Member;
		Variable.Buffer = &Buffer;
		Variable.Index = uint32_t(Buffer.Members.size());
		Buffer.Members.push_back(&Variable);
	}
	LayOut(Buffer);
	if (!Buffer.Offsets.empty())
	{
		const FLayout Last = GetLayout(*Types, Buffer.Members.back()->Type, ELayout::Constants);
		const uint64_t Size = uint64_t(Buffer.Offsets.back()) + Last.Size;
		if (Size > MaxBufferBytes)
		{
			Error(Buffer.Place, "the buffer '" + Buffer.Name + "' has " + std::to_string(Size) +
									" bytes; D3D has at most 65536, a StructuredBuffer more");
		}
	}
	Buffers.emplace_back(Order, &Buffer);
}

void FAnalyser::CheckAssert(const FDeclaration& Declaration)
{
	if (!Declaration.Value)
	{
		return;
	}
	FValue* const Value = Analyse(*Declaration.Value);
	if (IsError(Value))
	{
		return;
	}
	FValue* const Condition = MakeCondition(Value, "static_assert", "write all()");
	const std::optional<FConstant> Constant = IsError(Condition) ? std::nullopt : Fold(*Types, *Condition);
	if (!Constant && !IsError(Condition))
	{
		Error(Declaration.Place, "X3058: the condition of static_assert must be a constant expression");
	}
	else if (Constant && !Constant->at(0))
	{
		Error(Declaration.Place,
			"static_assert failed" + (Declaration.Text.empty() ? std::string() : ": " + std::string(Declaration.Text)));
	}
}

} // namespace Drydock::Hlsl
