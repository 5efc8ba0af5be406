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

/** The first number in a struct: "the number 'B'". */
std::string FindNumber(const FType* Type)
{
	while (Type->IsArray())
	{
		Type = Type->Element;
	}
	for (const FMember& Member : Type->IsStruct() ? Type->Struct->Members : std::vector<FMember>())
	{
		if (CountScalars(Member.Type) > 0)
		{
			return Member.Type->IsNumeric() ? "the number '" + Member.Name + "'" : FindNumber(Member.Type);
		}
	}
	return "numbers";
}

struct FRegisterRow
{
	std::string_view Letters;
	const char* What;
	const char* Number;
};

constexpr FRegisterRow RegisterRows[] = {
	{"b", "a constant buffer", "X3591"},
	{"ts", "a texture or a buffer that is read", "X3530"},
	{"u", "a UAV", "X3530"},
	{"st", "a sampler", "X3530"},
	{"cbi", "a parameter of numbers", "X3530"},
};

/** Not so the profile of `register(ps_5_0, s0)` and the space. */
bool IsRegister(std::string_view Text)
{
	return Text.size() > 1 && Text.find_first_not_of("0123456789", 1) == std::string_view::npos &&
		   !(Text[0] >= '0' && Text[0] <= '9');
}

const FRegisterRow* FindRegisterRow(const FType& Type, const FDeclaration& Declaration)
{
	const EObject Object = Type.Object;
	if (Declaration.Kind == EDeclaration::Buffer)
	{
		return &RegisterRows[Declaration.bTBuffer ? 1 : 0];
	}
	if (!Type.IsObject())
	{
		return Type.IsNumeric() ? &RegisterRows[4] : nullptr;
	}
	return Object == EObject::Unsupported                                                 ? nullptr
		   : Object == EObject::ConstantBuffer                                            ? &RegisterRows[0]
		   : IsWritable(Object)                                                           ? &RegisterRows[2]
		   : Object == EObject::SamplerState || Object == EObject::SamplerComparisonState ? &RegisterRows[3]
																						  : &RegisterRows[1];
}

} // namespace

/** `register(t0)`: the letter is that of what is declared. */
void FAnalyser::CheckRegisters(const FVariable& Variable, const FDeclaration& Declaration)
{
	const FType* Type = Variable.Type;
	while (Type->IsArray())
	{
		Type = Type->Element;
	}
	for (const FAnnotation& Annotation : Declaration.Annotations)
	{
		const auto Register = Annotation.Name != "register" ? Annotation.Arguments.end()
															: std::ranges::find_if(Annotation.Arguments, IsRegister);
		const FRegisterRow* const Row = FindRegisterRow(*Type, Declaration);
		if (Register == Annotation.Arguments.end() || !Row || Type->IsStruct())
		{
			continue;
		}
		const char Letter = char(Register->front() | 0x20);
		const bool bOld = Options.bFxcRules && Row == RegisterRows && Letter == 'c'; // FXC takes it for a cbuffer
		if (!bOld && Row->Letters.find(Letter) == std::string_view::npos)
		{
			Error(Annotation.Place, std::string(Row->Number) + ": " + Row->What + " requires " +
										(Row->Letters[0] == 's' ? "an '" : "a '") + Row->Letters[0] +
										"' register, not '" + std::string(*Register) + "'");
		}
	}
}

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
	CheckRegisters(Variable, Declaration);
	if (bObject && !bStatic)
	{
		Variable.Storage = EStorage::Resource;
		Resources.push_back(Made);
		if (CountScalars(Variable.Type) > 0)
		{
			Error(
				Variable.Place, "'" + Variable.Name + "' has " + FindNumber(Variable.Type) +
									" beside its resources, which a parameter of the shader cannot; declare it apart");
		}
		return;
	}
	if (Variable.Modifiers & ModifierGroupshared)
	{
		Variable.Storage = EStorage::Groupshared;
		Statics.push_back(Made);
		if (Value)
		{
			Warn(Value->Place,
				"'" + Variable.Name +
					"': groupshared variables have no initial values, and this one is not used; set it in "
					"the shader, and wait by GroupMemoryBarrierWithGroupSync()");
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

/** Parameters of the shader that nothing names: they lie in $Global beside those that are. */
void FAnalyser::AddUnusedLoose()
{
	for (auto& [Name, Symbol] : File->Symbols)
	{
		const FDeclaration* const Declaration = Symbol.Declaration;
		if (!Options.bAllLoose || !Global || Symbol.Kind != ESymbol::Variable || Symbol.Variable || Symbol.Buffer ||
			!Declaration || Symbol.bBusy)
		{
			continue;
		}
		const uint32_t Modifiers = Declaration->Modifiers | Declaration->Type->Modifiers;
		const bool bConstant = Modifiers & ModifierConst && Declaration->Value;
		if (bConstant || Modifiers & (ModifierStatic | ModifierGroupshared))
		{
			continue;
		}
		FPosition Position;
		Position.Scope = File;
		Position.Order = Symbol.Order;
		const FPositionGuard Guard(*this, Position);
		const FType* const Type = FindDeclaredType(*Declaration);
		if (Type->Kind != EType::Error && !HasObject(Type))
		{
			FindGlobal(Symbol);
		}
	}
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
											"' is not a place in a buffer; write packoffset(c0.x)");
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
	FVariable Whole;
	Whole.Type = Types->Void();
	CheckRegisters(Whole, Declaration);
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
